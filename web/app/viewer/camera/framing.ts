/** The nearest place from which a camera of a given direction sees all of some points. */

import { MathUtils, Vector3 } from 'three';
import type { PerspectiveCamera } from 'three';

/** Where a camera is put, and the point in the middle of its picture, at half the depth of the points. */
export interface View {
  eye: Vector3;
  centre: Vector3;
}

/** An interval of a half-space's offsets: how far the two sides of the picture have to be moved outwards. */
type Sides = [low: number, high: number];

/**
 * Takes points one by one. Those on one side of the picture have to lie inside of a plane through the eye, whose
 * direction is known, so that the outermost one determines the plane; the eye is where the planes of two opposite
 * sides meet, or farther away in the middle between them.
 */
export class Framing {
  private readonly back: Vector3;
  private readonly axes: { axis: Vector3; tangent: number; sides: Sides }[];
  private readonly depth: Sides = [Infinity, -Infinity];

  /** `toEye`: from the points towards the eye; `fill`: the largest fraction of the picture's width and height that they fill. */
  constructor({ fov, aspect, up }: PerspectiveCamera, toEye: Vector3, fill: number) {
    this.back = toEye.clone().normalize();
    const right = up.clone().cross(this.back).normalize();
    const above = this.back.clone().cross(right);
    const tangent = fill * Math.tan(MathUtils.degToRad(fov / 2));
    this.axes = [
      { axis: right, tangent: tangent * aspect, sides: [-Infinity, -Infinity] },
      { axis: above, tangent, sides: [-Infinity, -Infinity] },
    ];
  }

  take(point: Vector3): void {
    const near = point.dot(this.back);
    this.depth[0] = Math.min(this.depth[0], near);
    this.depth[1] = Math.max(this.depth[1], near);
    for (const { axis, tangent, sides } of this.axes) {
      const aside = point.dot(axis);
      sides[0] = Math.max(sides[0], tangent * near - aside);
      sides[1] = Math.max(sides[1], tangent * near + aside);
    }
  }

  /** The view of all points taken, at least one. */
  view(): View {
    const nearest = this.axes.map(({ tangent, sides: [low, high] }) => (low + high) / (2 * tangent));
    const inPlane = new Vector3();
    for (const { axis, sides } of this.axes) inPlane.addScaledVector(axis, (sides[1] - sides[0]) / 2);
    const at = (depth: number) => inPlane.clone().addScaledVector(this.back, depth);
    return { eye: at(Math.max(...nearest)), centre: at((this.depth[0] + this.depth[1]) / 2) };
  }
}
