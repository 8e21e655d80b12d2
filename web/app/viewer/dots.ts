/** Round dots of fixed screen size over the surface, one for each marked vertex. */

import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';
import type { TriangleMesh } from '../../engine/core/core';

const vertexShader = /* glsl */ `
  uniform float size;
  uniform float amplitude;
  attribute vec3 displacement;
  void main() {
    vec3 viewPosition = (modelViewMatrix * vec4(position + amplitude * displacement, 1.0)).xyz;
    // Dots are moved slightly towards the camera, so that the surface around the vertex does not intersect them.
    gl_Position = projectionMatrix * vec4(0.985 * viewPosition, 1.0);
    gl_PointSize = size;
  }
`;

const fragmentShader = /* glsl */ `
  uniform vec3 fill;
  uniform vec3 rim;
  uniform float size;
  uniform float rimWidth;
  void main() {
    float radius = length(gl_PointCoord - 0.5);
    if (radius > 0.5) discard;
    gl_FragColor = vec4((0.5 - radius) * size < rimWidth ? rim : fill, 1.0);
    #include <colorspace_fragment>
  }
`;

export interface DotLook {
  fill: string;
  rim: string;
}

/** In pictures of less height dots are smaller, because they would hide the body. CSS pixels. */
const FULL_HEIGHT = 300;
const SMALLEST = 0.5;

export class Dots {
  private scale = 1;
  readonly points: Points<BufferGeometry, ShaderMaterial>;

  constructor(private pixelRatio: number) {
    const uniforms = {
      size: { value: 1 },
      amplitude: { value: 0 },
      rimWidth: { value: 0 },
      fill: { value: new Color() },
      rim: { value: new Color() },
    };
    const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms });
    this.points = new Points(new BufferGeometry(), material);
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  show({ positions }: TriangleMesh, vertices: Iterable<number>): void {
    const points = [...vertices].flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]);
    this.setPoints(Float32Array.from(points));
  }

  /** `positions[3 i + c]`; `displacement[3 i + c]` at full swing over the amplitude. */
  setPoints(positions: Float32Array, displacement: Float32Array | null = null): void {
    this.points.geometry.dispose();
    this.points.geometry = new BufferGeometry();
    this.points.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    if (displacement) this.points.geometry.setAttribute('displacement', new BufferAttribute(displacement, 3));
    this.points.visible = positions.length > 0;
    this.setPixelRatio(this.pixelRatio);
  }

  /** Pixels of the canvas per CSS pixel. */
  setPixelRatio(pixelRatio: number): void {
    this.pixelRatio = pixelRatio;
    const { geometry, material } = this.points;
    const [size, rimWidth] = inPixels(geometry.getAttribute('position')?.count ?? 0);
    material.uniforms.size.value = pixelRatio * this.scale * size;
    material.uniforms.rimWidth.value = pixelRatio * this.scale * rimWidth;
  }

  /** `height` of the picture, in CSS pixels. */
  fit(height: number): void {
    const scale = Math.min(1, Math.max(SMALLEST, height / FULL_HEIGHT));
    if (scale === this.scale) return;
    this.scale = scale;
    this.setPixelRatio(this.pixelRatio);
  }

  swing(amplitude: number): void {
    this.points.material.uniforms.amplitude.value = amplitude;
  }

  look({ fill, rim }: DotLook): void {
    this.points.material.uniforms.fill.value.set(fill);
    this.points.material.uniforms.rim.value.set(rim);
  }
}

/** Diameter and rim in CSS pixels. If there are many, dots are small and have no rim, which would hide their neighbours. */
function inPixels(count: number): [number, number] {
  if (count <= 40) return [10, 1.5];
  if (count <= 150) return [7, 1];
  return count <= 500 ? [5, 0] : [4, 0];
}
