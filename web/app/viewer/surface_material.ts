/** The material of all bodies: a lit surface, coloured by a field, with the edges of its triangles drawn in the shader. */

import { Color, DoubleSide, ShaderMaterial } from 'three';
import type { DataTexture } from 'three';

export interface SurfaceLook {
  /** of a surface without a field */
  clay: Color;
  wire: Color;
  /** 0..1 */
  wireStrength: number;
}

const vertexShader = /* glsl */ `
  attribute vec3 displacement;
  attribute float value;
  attribute vec2 paint;
  uniform float amplitude;
  varying vec3 vNormal;
  varying vec3 vPosition;
  varying vec3 vCorner;
  varying float vValue;
  varying vec2 vPaint;
  void main() {
    // Triangles share no corners, so the index of a vertex determines which corner of its triangle it is.
    int corner = gl_VertexID % 3;
    vCorner = vec3(corner == 0, corner == 1, corner == 2);
    vValue = value;
    vPaint = paint;
    vec4 viewPosition = modelViewMatrix * vec4(position + amplitude * displacement, 1.0);
    vPosition = viewPosition.xyz;
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * viewPosition;
  }
`;

const fragmentShader = /* glsl */ `
  varying vec3 vNormal;
  varying vec3 vPosition;
  varying vec3 vCorner;
  varying float vValue;
  varying vec2 vPaint;
  uniform sampler2D map;
  uniform bool hasField;
  uniform bool isFlat;
  uniform vec3 clay;
  uniform vec3 wire;
  uniform float wireStrength;
  uniform vec3 keep;
  uniform vec3 lock;
  uniform float hatchPixels;
  uniform float opacity;
  void main() {
    vec3 faceNormal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    vec3 n = isFlat ? faceNormal : normalize(vNormal);
    vec3 toEye = normalize(-vPosition);
    if (dot(n, toEye) < 0.0) n = -n;
    vec3 base = hasField ? texture(map, vec2(clamp(vValue, 0.0, 1.0) * 0.992 + 0.004, 0.5)).rgb : clay;
    base = mix(base, keep, vPaint.x > 0.0 ? 0.25 + 0.65 * vPaint.x : 0.0);
    // Locks are hatched, so that they can be recognised without colour.
    float hatch = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / hatchPixels));
    base = mix(base, mix(lock, vec3(1.0), 0.75 * hatch), step(0.5, vPaint.y));
    float key = max(dot(n, normalize(vec3(0.35, 0.75, 0.55))), 0.0);
    float fill = max(dot(n, normalize(vec3(-0.7, 0.1, 0.4))), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    float gloss = pow(max(dot(n, normalize(normalize(vec3(0.35, 0.75, 0.55)) + toEye)), 0.0), 40.0);
    vec3 lit = base * (0.30 + 0.20 * sky + 0.55 * key + 0.14 * fill) + 0.07 * gloss;
    vec3 width = fwidth(vCorner);
    vec3 edge = smoothstep(vec3(0.0), width * 1.25, vCorner);
    float onEdge = 1.0 - min(min(edge.x, edge.y), edge.z);
    // The edges of triangles smaller than a few pixels fade out, because they would cover the surface.
    float fade = 1.0 - smoothstep(0.25, 0.9, max(max(width.x, width.y), width.z));
    gl_FragColor = vec4(mix(lit, wire, onEdge * wireStrength * (0.35 + 0.65 * fade)), opacity);
    #include <colorspace_fragment>
  }
`;

/** The width of the hatches of locks, in CSS pixels. */
export const HATCH_PIXELS = 8;

/** Colours of painted vertices, the same in both colour schemes. */
export const PAINT = { keep: '#e0218a', lock: '#0b3d91' };

export function surfaceMaterial(map: DataTexture, look: SurfaceLook): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: DoubleSide,
    uniforms: {
      map: { value: map },
      amplitude: { value: 0 },
      hasField: { value: false },
      isFlat: { value: false },
      opacity: { value: 1 },
      clay: { value: look.clay },
      wire: { value: look.wire },
      wireStrength: { value: look.wireStrength },
      keep: { value: new Color(PAINT.keep) },
      lock: { value: new Color(PAINT.lock) },
      hatchPixels: { value: HATCH_PIXELS * Math.min(2, devicePixelRatio) },
    },
  });
}
