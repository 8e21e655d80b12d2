/** Dots over the surface, one for each vertex that is held in place. */

import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';
import type { TriangleMesh } from '../../engine/core';

const vertexShader = /* glsl */ `
  uniform float size;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    // A little towards the eye, so that the surface around the vertex does not cut the dot.
    gl_Position.z -= 0.0015 * gl_Position.w;
    gl_PointSize = size;
  }
`;

const fragmentShader = /* glsl */ `
  uniform vec3 fill;
  uniform vec3 rim;
  void main() {
    float radius = length(gl_PointCoord - 0.5);
    if (radius > 0.5) discard;
    gl_FragColor = vec4(radius > 0.34 ? rim : fill, 1.0);
    #include <colorspace_fragment>
  }
`;

export interface DotLook {
  fill: string;
  rim: string;
}

export class PinDots {
  readonly points: Points<BufferGeometry, ShaderMaterial>;

  constructor(private readonly pixelRatio: number) {
    const uniforms = { size: { value: 1 }, fill: { value: new Color() }, rim: { value: new Color() } };
    const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms });
    this.points = new Points(new BufferGeometry(), material);
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  show({ positions }: TriangleMesh, vertices: Iterable<number>): void {
    const places = Float32Array.from(
      [...vertices].flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]),
    );
    this.points.geometry.dispose();
    this.points.geometry = new BufferGeometry();
    this.points.geometry.setAttribute('position', new BufferAttribute(places, 3));
    this.points.visible = places.length > 0;
    this.points.material.uniforms.size.value = this.pixelRatio * diameter(places.length / 3);
  }

  look({ fill, rim }: DotLook): void {
    this.points.material.uniforms.fill.value.set(fill);
    this.points.material.uniforms.rim.value.set(rim);
  }
}

/** In CSS pixels: many dots are small, so that the surface is still seen between them. */
const diameter = (count: number): number => (count <= 200 ? 10 : count <= 2000 ? 7 : 5);
