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

  constructor(private readonly orbit: OrbitCamera) {}

  /**
   * Calls `change`, which may make the picture narrower, and moves the camera back so far that its previous horizontal
   * range stays in the picture, and forward again when it becomes wider. `corners`: of the bounding box at rest.
   */
  keepWidth(corners: readonly Vector3[], change: () => void): void {
    const { orbit } = this;
    const before = orbit.spreadOf(corners).across;
    const { aspect } = orbit.camera;
    change();
    const ratio = aspect / orbit.camera.aspect;
    if (ratio === 1) return;
    orbit.stepBack('width', Math.max(1, (orbit.factors.width * before * ratio) / Math.max(FILL, before)));
  }

  /** Moves the camera back if bodies at these positions, `[3 v + c]`, extend beyond the picture, unless the user has framed the view. */
  keepMotion(corners: readonly Vector3[], bodies: readonly Float32Array[]): void {
    const { orbit } = this;
    if (this.motionLimit === null) this.beginMotion(Math.max(1, spreadOf(orbit, corners)));
    if (orbit.isFramedByUser || this.motionLimit === null) return;
    const spread = Math.max(...bodies.map((positions) => spreadOf(orbit, sampled(positions))));
    if (!(spread > this.motionLimit)) return;
    const factor = (orbit.shareOfWay() * orbit.factors.motion * spread) / (FILL * this.motionLimit);
    const most = Math.min(MAX_FOR_MOTION, factor);
    if (most > orbit.factors.motion) orbit.stepBack('motion', most, true);
  }

  private beginMotion(limit: number): void {
    this.motionLimit = limit;
    this.orbit.isFramedByUser = false;
  }

  /** Nothing moves any more: the camera returns to its previous distance. */
  endMotion(): void {
    this.motionLimit = null;
    if (this.orbit.isFramedByUser) this.orbit.forgetFactor('motion');
    else this.orbit.stepBack('motion', 1);
  }

  /** The camera has been framed on the whole content. */
  fitted(): void {
    if (this.motionLimit !== null) this.motionLimit = 1;
    this.orbit.isFramedByUser = false;
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
