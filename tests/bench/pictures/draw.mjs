// Pictures of triangles by orthographic projection, shaded and textured as an engine shows them: faces that are turned away are
// not seen unless their material has two sides.

import sharp from 'sharp';

export const SIZE = 320;
/** From in front, from the right behind and from the left below. */
const DIRECTIONS = [
  [0.3, 0.35, 1],
  [1, 0.5, -0.8],
  [-0.9, -0.4, 0.6],
];
const BACKGROUND = 90;
const LIGHT = unit([0.4, 0.8, 0.5]);

/** Three views that hold all triangles. */
export function viewsOf(shown) {
  return DIRECTIONS.map((direction) => {
    const w = unit(direction);
    const u = unit(cross([0, 1, 0], w));
    const v = cross(w, u);
    const [low, high] = [
      [Infinity, Infinity],
      [-Infinity, -Infinity],
    ];
    for (const { positions } of shown)
      for (let i = 0; i < positions.length; i += 3)
        [u, v].forEach((axis, c) => {
          const at = dot(axis, positions, i);
          low[c] = Math.min(low[c], at);
          high[c] = Math.max(high[c], at);
        });
    const span = 1.08 * Math.max(high[0] - low[0], high[1] - low[1], 1e-30);
    return {
      u,
      v,
      w,
      x: (low[0] + high[0] - span) / 2,
      y: (low[1] + high[1] - span) / 2,
      scale: SIZE / span,
    };
  });
}

/** Three bytes for each pixel, from the upper left. */
export function drawn(shown, view) {
  const picture = new Uint8Array(3 * SIZE * SIZE).fill(BACKGROUND);
  const depths = new Float64Array(SIZE * SIZE).fill(-Infinity);
  for (const list of shown)
    for (let t = 0; t < list.positions.length / 9; ++t) drawTriangle(list, 3 * t, view, { picture, depths });
  return picture;
}

function drawTriangle(list, first, view, { picture, depths }) {
  const [a, b, c] = [0, 3, 6].map((k) => {
    const i = 3 * first + k;
    const [x, y] = [dot(view.u, list.positions, i) - view.x, dot(view.v, list.positions, i) - view.y];
    return [view.scale * x, SIZE - view.scale * y, dot(view.w, list.positions, i)];
  });
  // Rows run downwards, so that a face seen from its front has a negative area.
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (area === 0 || (area > 0 && !list.isDoubleSided)) return;
  const clamp = (value) => Math.min(SIZE - 1, Math.max(0, value));
  const rows = [Math.floor(Math.min(a[1], b[1], c[1])), Math.ceil(Math.max(a[1], b[1], c[1]))].map(clamp);
  const columns = [Math.floor(Math.min(a[0], b[0], c[0])), Math.ceil(Math.max(a[0], b[0], c[0]))].map(clamp);
  for (let y = rows[0]; y <= rows[1]; ++y)
    for (let x = columns[0]; x <= columns[1]; ++x) {
      const [px, py] = [x + 0.5, y + 0.5];
      const q = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
      const r = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
      const p = 1 - q - r;
      if (p < 0 || q < 0 || r < 0) continue;
      const depth = p * a[2] + q * b[2] + r * c[2];
      const at = y * SIZE + x;
      if (!(depth > depths[at])) continue;
      depths[at] = depth;
      picture.set(colourAt(list, first, [p, q, r], view, area > 0), 3 * at);
    }
}

function colourAt(list, first, shares, view, isTurned) {
  const mix = (values, size) =>
    Array.from({ length: size }, (_, c) =>
      shares.reduce((sum, share, k) => sum + share * values[size * (first + k) + c], 0),
    );
  const normal = unit(mix(list.normals, 3)).map((value) => (isTurned ? -value : value));
  const light = 0.25 + 0.6 * Math.max(0, dot(LIGHT, normal, 0)) + 0.15 * Math.max(0, dot(view.w, normal, 0));
  const colour = list.colours ? mix(list.colours, 3) : [1, 1, 1];
  const texel = list.uv ? texelAt(list.texture, mix(list.uv, 2)) : [255, 255, 255];
  return [0, 1, 2].map((c) =>
    Math.round(texel[c] * Math.min(1, light * Math.sqrt(colour[c] * list.factor[c]))),
  );
}

/** Between the four nearest texels; the texture repeats. */
function texelAt({ data, width, height }, [u, v]) {
  const [x, y] = [u * width - 0.5, v * height - 0.5];
  const [left, top] = [Math.floor(x), Math.floor(y)];
  const wrapped = (value, size) => ((value % size) + size) % size;
  const at = (i, j, c) => data[3 * (wrapped(top + j, height) * width + wrapped(left + i, width)) + c];
  const [fx, fy] = [x - left, y - top];
  return [0, 1, 2].map(
    (c) =>
      (1 - fy) * ((1 - fx) * at(0, 0, c) + fx * at(1, 0, c)) +
      fy * ((1 - fx) * at(0, 1, c) + fx * at(1, 1, c)),
  );
}

/** Peak signal to noise in dB over all views, at most 45. */
export function psnr(before, after) {
  let [squares, count] = [0, 0];
  before.forEach((picture, view) =>
    picture.forEach((value, i) => {
      squares += (value - after[view][i]) ** 2;
      ++count;
    }),
  );
  return squares === 0 ? 45 : Math.min(45, 10 * Math.log10((255 * 255 * count) / squares));
}

/** The views side by side as a PNG file; each row of `rows` is one list of pictures. */
export async function writeSheet(path, rows) {
  const input = (picture) => ({
    input: Buffer.from(picture),
    raw: { width: SIZE, height: SIZE, channels: 3 },
  });
  await sharp({
    create: { width: SIZE * rows[0].length, height: SIZE * rows.length, channels: 3, background: 'black' },
  })
    .composite(
      rows.flatMap((row, y) =>
        row.map((picture, x) => ({ ...input(picture), left: x * SIZE, top: y * SIZE })),
      ),
    )
    .png()
    .toFile(path);
}

function dot(a, b, i) {
  return a[0] * b[i] + a[1] * b[i + 1] + a[2] * b[i + 2];
}
function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
function unit(a) {
  const length = Math.hypot(...a);
  return length > 0 ? a.map((value) => value / length) : a;
}
