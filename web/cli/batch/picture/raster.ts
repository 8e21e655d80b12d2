/** Draws triangles into a small picture, shaded flat, so that coarse facets can be seen. */

import type { Camera } from './camera';

/** Grey values from the upper left, row by row. */
export interface Picture {
  width: number;
  height: number;
  pixels: Uint8Array;
}

/** Every pixel is the mean of this many squared. */
const SAMPLES = 2;
const BACKGROUND = 250;
/** Towards the light, in the axes of the camera, of length 1. */
const LIGHT = [-0.37, 0.56, 0.74];
const [DARKEST, BRIGHTEST] = [25, 205];

interface Target {
  side: number;
  grey: Uint8Array;
  depth: Float32Array;
}

/** `triangles[9 t + 3 corner + c]`. Both sides of a triangle are drawn. */
export function draw(triangles: Float32Array, camera: Camera, size: number): Picture {
  const side = size * SAMPLES;
  const target: Target = {
    side,
    grey: new Uint8Array(side * side).fill(BACKGROUND),
    depth: new Float32Array(side * side).fill(-Infinity),
  };
  const corners = new Float64Array(9);
  for (let t = 0; t + 9 <= triangles.length; t += 9) {
    for (let corner = 0; corner < 3; ++corner)
      project(triangles, t + 3 * corner, camera, { corners, side, corner });
    fill(target, corners);
  }
  return reduce(target, size);
}

function project(
  triangles: Float32Array,
  at: number,
  { axes, origin, span }: Camera,
  { corners, side, corner }: { corners: Float64Array; side: number; corner: number },
): void {
  const scale = side / span;
  const along = (c: number) =>
    axes[c][0] * triangles[at] + axes[c][1] * triangles[at + 1] + axes[c][2] * triangles[at + 2];
  corners[3 * corner] = (along(0) - origin[0]) * scale;
  corners[3 * corner + 1] = side - (along(1) - origin[1]) * scale;
  corners[3 * corner + 2] = along(2) * scale;
}

/** Fills the pixels whose middles lie in the triangle, where nothing nearer is. */
function fill({ side, grey, depth }: Target, p: Float64Array): void {
  // The numbers are named one by one: arrays of them would be made anew for every pixel.
  const ux = p[3] - p[0];
  const uy = p[4] - p[1];
  const uz = p[5] - p[2];
  const vx = p[6] - p[0];
  const vy = p[7] - p[1];
  const vz = p[8] - p[2];
  const area = ux * vy - uy * vx;
  if (!Number.isFinite(area) || area === 0) return;
  const value = shade(uy * vz - uz * vy, uz * vx - ux * vz, area);
  const last = side - 1;
  const x0 = clamp(Math.floor(Math.min(p[0], p[3], p[6])), last);
  const x1 = clamp(Math.ceil(Math.max(p[0], p[3], p[6])), last);
  const y0 = clamp(Math.floor(Math.min(p[1], p[4], p[7])), last);
  const y1 = clamp(Math.ceil(Math.max(p[1], p[4], p[7])), last);
  for (let y = y0; y <= y1; ++y)
    for (let x = x0; x <= x1; ++x) {
      const dx = x + 0.5 - p[0];
      const dy = y + 0.5 - p[1];
      const b = (dx * vy - dy * vx) / area;
      const c = (ux * dy - uy * dx) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const z = p[2] + b * uz + c * vz;
      if (z <= depth[y * side + x]) continue;
      depth[y * side + x] = z;
      grey[y * side + x] = value;
    }
}

const clamp = (at: number, last: number): number => Math.min(last, Math.max(0, at));

/** Of a normal of any length whose side does not matter; y of the picture goes down. */
function shade(x: number, y: number, z: number): number {
  const towards = z < 0 ? -1 : 1;
  const cosine = (towards * (LIGHT[0] * x - LIGHT[1] * y + LIGHT[2] * z)) / Math.hypot(x, y, z);
  return Math.round(DARKEST + (BRIGHTEST - DARKEST) * Math.max(0, Math.min(1, 0.5 + 0.5 * cosine)));
}

function reduce({ side, grey }: Target, size: number): Picture {
  const pixels = new Uint8Array(size * size);
  for (let y = 0; y < size; ++y)
    for (let x = 0; x < size; ++x) {
      let sum = 0;
      for (let i = 0; i < SAMPLES * SAMPLES; ++i)
        sum += grey[(SAMPLES * y + Math.floor(i / SAMPLES)) * side + SAMPLES * x + (i % SAMPLES)];
      pixels[y * size + x] = Math.round(sum / (SAMPLES * SAMPLES));
    }
  return { width: size, height: size, pixels };
}

/** Pictures of one height side by side. */
export function beside(pictures: Picture[]): Picture {
  const [{ height }] = pictures;
  const width = pictures.reduce((sum, picture) => sum + picture.width, 0);
  const pixels = new Uint8Array(width * height);
  let left = 0;
  for (const picture of pictures) {
    for (let y = 0; y < height; ++y)
      pixels.set(picture.pixels.subarray(y * picture.width, (y + 1) * picture.width), y * width + left);
    left += picture.width;
  }
  return { width, height, pixels };
}
