/** Points spread over triangles, for what needs to know roughly where a surface is. */

const WANTED = 60_000;
const MOST_PER_SIDE = 12;

/**
 * Points on all triangles, `points[3 i + c]`, their corners among them; few triangles get more points each. `positions[3 v + c]`;
 * `index`: three vertices per triangle, null where they follow each other.
 */
export function spreadPoints(positions: ArrayLike<number>, index: ArrayLike<number> | null): Float32Array {
  const corners = index?.length ?? positions.length / 3;
  const count = Math.floor(corners / 3);
  const side = Math.min(MOST_PER_SIDE, Math.max(1, Math.floor(Math.sqrt(WANTED / Math.max(1, count)))));
  const step = Math.max(1, Math.floor(count / WANTED));
  const points: number[] = [];
  const vertex = (corner: number): number => 3 * (index ? index[corner] : corner);
  for (let t = 0; t < count; t += step) {
    const [a, b, c] = [vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)];
    for (let i = 0; i <= side; i++)
      for (let j = 0; i + j <= side; j++) {
        const [u, v] = [i / side, j / side];
        for (let k = 0; k < 3; k++)
          points.push(positions[a + k] * (1 - u - v) + positions[b + k] * u + positions[c + k] * v);
      }
  }
  return Float32Array.from(points);
}
