// Points whose motion is tracked, distributed evenly over a surface.

const COUNT = 1000;
/** Steps of a sequence that fills the unit square evenly: 1 / p and 1 / p^2 with p^3 = p + 1. */
const [STEP_U, STEP_V] = [0.7548776662466927, 0.5698402909980532];

/** 1,000 points, [{ triangle, barycentric }], stratified by the cumulative area of the triangles. */
export function samplePoints({ positions, triangles }) {
  const areas = Array.from({ length: triangles.length / 3 }, (_, t) => areaOf(positions, triangles, t));
  const total = areas.reduce((sum, area) => sum + area, 0);
  const points = [];
  let [triangle, before] = [0, 0];
  for (let i = 0; i < COUNT; ++i) {
    const at = (total * (i + 0.5)) / COUNT;
    while (before + areas[triangle] < at && triangle < areas.length - 1) before += areas[triangle++];
    const [u, v] = [(i * STEP_U) % 1, (i * STEP_V) % 1];
    const [b, c] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
    points.push({ triangle, barycentric: [1 - b - c, b, c] });
  }
  return points;
}

function areaOf(positions, triangles, t) {
  const [a, b, c] = [0, 1, 2].map((k) => 3 * triangles[3 * t + k]);
  const [x, y] = [b, c].map((to) => [0, 1, 2].map((k) => positions[to + k] - positions[a + k]));
  return (
    0.5 *
    Math.hypot(...[0, 1, 2].map((k) => x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3]))
  );
}
