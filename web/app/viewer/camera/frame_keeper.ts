/** Keeps the view framed when the picture becomes narrower, and when a body moves out of it. */

import { Vector3 } from 'three';
import type { OrbitCamera } from './orbit_camera';

/** The largest fraction of half the picture that the content fills when the camera has to move back for it. */
const FILL = 0.9;
/** A body that moves farther than this many times the distance is let go. */
const MAX_FOR_MOTION = 3;
/** So many vertices of a moving body are looked at. */
const SAMPLES = 400;

export class FrameKeeper {
  /** the extent of moving bodies; null: that of the body at rest, not yet computed */
  private motionLimit: number | null = null;
  /** how often the user had framed the view when it was last fitted, and when the motion began */
  private framingsAtFit = 0;
  private framingsAtMotion = 0;

  constructor(private readonly orbit: OrbitCamera) {}

  /**
   * Calls `change`, which may make the picture narrower or wider, and frames the content again, unless the user has
   * framed the view or the content moves: then the camera moves back so far that its previous horizontal range stays in
   * the picture, and forward again when it becomes wider. `outline`: the outermost points at rest.
   */
  keepWidth(outline: readonly Vector3[], change: () => void): void {
    const { orbit } = this;
    const before = orbit.spreadOf(outline).across;
    const { aspect } = orbit.camera;
    change();
    const ratio = aspect / orbit.camera.aspect;
    if (ratio === 1 || outline.length === 0) return;
    if (orbit.framings === this.framingsAtFit && orbit.factors.motion === 1)
      return orbit.fit(outline, { from: 'here', isAnimated: false });
    // If the picture shows a part of the body, that part is taken to be as far away as the orbit centre.
    const way = before > 1 ? ratio : orbit.wayToFit(outline, FILL);
    orbit.stepBack('width', Math.max(1, orbit.factors.width * way));
  }

  /** Moves the camera back if bodies at these positions, `[3 v + c]`, extend beyond the picture, unless the user has framed the view. */
  keepMotion(outline: readonly Vector3[], bodies: readonly Float32Array[]): void {
    const { orbit } = this;
    if (this.motionLimit === null) this.beginMotion(Math.max(1, spreadOf(orbit, outline)));
    if (this.isFramedInMotion() || this.motionLimit === null) return;
    const spread = Math.max(...bodies.map((positions) => spreadOf(orbit, sampled(positions))));
    if (!(spread > this.motionLimit)) return;
    const factor = (orbit.shareOfWay() * orbit.factors.motion * spread) / (FILL * this.motionLimit);
    const most = Math.min(MAX_FOR_MOTION, factor);
    if (most > orbit.factors.motion) orbit.stepBack('motion', most, true);
  }

  private beginMotion(limit: number): void {
    this.motionLimit = limit;
    this.framingsAtMotion = this.orbit.framings;
  }

  /** Whether the user has framed the view while the bodies move. */
  private isFramedInMotion(): boolean {
    return this.orbit.framings !== this.framingsAtMotion;
  }

  /** Nothing moves any more: the camera returns to its previous distance. */
  endMotion(): void {
    this.motionLimit = null;
    if (this.isFramedInMotion()) this.orbit.forgetFactor('motion');
    else this.orbit.stepBack('motion', 1);
  }

  /** The camera has been framed on the whole content. */
  fitted(): void {
    if (this.motionLimit !== null) this.motionLimit = 1;
    this.framingsAtFit = this.framingsAtMotion = this.orbit.framings;
  }
}

function spreadOf(orbit: OrbitCamera, points: readonly Vector3[]): number {
  const { across, up } = orbit.spreadOf(points);
  return Math.max(across, up);
}

function sampled(positions: Float32Array): Vector3[] {
  const count = positions.length / 3;
  const step = Math.max(1, Math.floor(count / SAMPLES));
  const points: Vector3[] = [];
  for (let v = 0; v < count; v += step) points.push(new Vector3().fromArray(positions, 3 * v));
  return points;
}
