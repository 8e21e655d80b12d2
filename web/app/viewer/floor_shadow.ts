/** A soft shadow on a floor, as if light came from everywhere above: parts near the floor darken it more. */

export interface ShadowArea {
  /** x, y, z of the centre of the floor */
  centre: readonly [number, number, number];
  /** length of a side of the square that the picture covers */
  side: number;
  /** height above the floor from which nothing darkens it */
  top: number;
}

export const SHADOW_SIZE = 96;
/** Passes of a box filter; three are close to a Gaussian. */
const PASSES = 3;
/** Radius of the filter in cells. */
const RADIUS = 3;
const DARKEST = 0.3;

/**
 * The darkness of the floor, 0..1, `shadow[row * SHADOW_SIZE + column]`, with columns along x and rows along z.
 * `points[3 i + c]` are spread over the objects on the floor, in the space of the scene.
 */
export function floorShadow(points: Float32Array, area: ShadowArea): Float32Array {
  let shadow = scatter(points, area);
  for (let pass = 0; pass < PASSES; pass++) shadow = blurred(blurred(shadow, 1), SHADOW_SIZE);
  const most = shadow.reduce((largest, value) => Math.max(largest, value), 0) || 1;
  return shadow.map((value) => DARKEST * Math.min(1, (1.4 * value) / most));
}

/** The largest weight of any point above each cell. */
function scatter(points: Float32Array, { centre, side, top }: ShadowArea): Float32Array {
  const cells = new Float32Array(SHADOW_SIZE * SHADOW_SIZE);
  for (let i = 0; i < points.length; i += 3) {
    const column = Math.floor(((points[i] - centre[0]) / side + 0.5) * SHADOW_SIZE);
    const row = Math.floor(((points[i + 2] - centre[2]) / side + 0.5) * SHADOW_SIZE);
    if (column < 0 || row < 0 || column >= SHADOW_SIZE || row >= SHADOW_SIZE) continue;
    const height = Math.max(0, (points[i + 1] - centre[1]) / top);
    const weight = Math.max(0.06, (1 - height) ** 2 * Number(height < 1));
    const at = row * SHADOW_SIZE + column;
    cells[at] = Math.max(cells[at], weight);
  }
  return cells;
}

/** The mean over neighbours at a distance of `step` in the array: 1 along rows, SHADOW_SIZE along columns. */
function blurred(cells: Float32Array, step: number): Float32Array {
  const out = new Float32Array(cells.length);
  for (let at = 0; at < cells.length; at++) {
    const own = step === 1 ? at % SHADOW_SIZE : Math.floor(at / SHADOW_SIZE);
    let sum = 0;
    for (let d = -RADIUS; d <= RADIUS; d++)
      if (own + d >= 0 && own + d < SHADOW_SIZE) sum += cells[at + d * step];
    out[at] = sum / (2 * RADIUS + 1);
  }
  return out;
}
