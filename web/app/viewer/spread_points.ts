/** Points spread over triangles, which locate a surface approximately. */

const WANTED = 60_000;
const MAX_PER_SIDE = 12;

/** The interval of triangles with points among `count` triangles. */
export const spreadStep = (triangles: number): number => Math.max(1, Math.floor(triangles / WANTED));

/**
 * Points on all triangles, `points[3 i + c]`, including their corners; few triangles get more points each, and of many
 * triangles only some get any, see `spreadStep`. `positions[3 v + c]`; `index`: three vertices per triangle, null if
 * they are consecutive.
 */
export function spreadPoints(positions: ArrayLike<number>, index: ArrayLike<number> | null): Float32Array {
  const corners = index?.length ?? positions.length / 3;
  const count = Math.floor(corners / 3);
  const side = Math.min(MAX_PER_SIDE, Math.max(1, Math.floor(Math.sqrt(WANTED / Math.max(1, count)))));
  const step = spreadStep(count);
  const points = new Float32Array(3 * Math.ceil(count / step) * (((side + 1) * (side + 2)) / 2));
  const vertex = (corner: number): number => 3 * (index ? index[corner] : corner);
  let to = 0;
  for (let t = 0; t < count; t += step) {
    const a = vertex(3 * t);
    const b = vertex(3 * t + 1);
    const c = vertex(3 * t + 2);
    for (let i = 0; i <= side; i++)
      for (let j = 0; i + j <= side; j++)
        for (let k = 0; k < 3; k++)
          points[to++] =
            (positions[a + k] * (side - i - j) + positions[b + k] * i + positions[c + k] * j) / side;
  }
  return points;
}
