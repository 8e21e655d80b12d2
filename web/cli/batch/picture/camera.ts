/** How the pictures of an asset look at it: from the front, a little from the right and above, without perspective. */

/** Where points of the scene are in a square picture; depth grows towards the eye. */
export interface Camera {
  /** to the right, up and towards the eye, of length 1 */
  axes: readonly (readonly [number, number, number])[];
  /** what of the first two axes is at the left and lower edge */
  origin: readonly [number, number];
  /** the side of the square, in units of the scene */
  span: number;
}

/** Part of the span that stays empty around the model. */
const MARGIN = 0.06;

const AXES: Camera['axes'] = viewFrom(30, 20);

/** The axes of a view that is turned by so many degrees to the right and above. */
function viewFrom(right: number, above: number): Camera['axes'] {
  const [a, b] = [(right * Math.PI) / 180, (above * Math.PI) / 180];
  return [
    [Math.cos(a), 0, -Math.sin(a)],
    [-Math.sin(a) * Math.sin(b), Math.cos(b), -Math.cos(a) * Math.sin(b)],
    [Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)],
  ];
}

/** Such that all points, three numbers each, fill the picture; points that are not finite do not count. */
export function cameraOn(points: Float32Array): Camera {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3)
    for (let c = 0; c < 2; ++c) {
      const [x, y, z] = AXES[c];
      const at = x * points[i] + y * points[i + 1] + z * points[i + 2];
      if (!Number.isFinite(at)) continue;
      low[c] = Math.min(low[c], at);
      high[c] = Math.max(high[c], at);
    }
  const size = Math.max(high[0] - low[0], high[1] - low[1]);
  const span = (size > 0 ? size : 1) * (1 + 2 * MARGIN);
  const middle = (c: number) => (low[c] <= high[c] ? (low[c] + high[c]) / 2 : 0);
  return { axes: AXES, origin: [middle(0) - span / 2, middle(1) - span / 2], span };
}
