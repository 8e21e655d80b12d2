/** The camera that all panes share, and its pointer control. */

import CameraControls from 'camera-controls';
import * as THREE from 'three';
import { Framing } from './framing';

CameraControls.install({ THREE });

/** From the body towards the eye, in a view from the front, before it is normalised. */
const FRONT: [number, number, number] = [0.75, 0.42, 1];
/** The largest fraction of the picture's height and width that a body fills. */
const FILL = 0.8;
/** The largest distance in radii: farther away a body would shrink to a dot. */
const FARTHEST = 40;

/** Points behind the camera count as if they were this close in front of it. */
const NEAREST = 1e-9;

/** Reasons for a larger distance: the picture has become narrower, or a body moves out of it. */
type Reason = 'width' | 'motion';

export interface HowToFit {
  /** the direction of the view: from the front, or unchanged */
  from: 'front' | 'here';
  isAnimated: boolean;
}

export class OrbitCamera {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  private readonly controls: CameraControls;
  /** factors on the distance that the user has chosen */
  readonly factors: Record<Reason, number> = { width: 1, motion: 1 };
  /** how often the user has zoomed or moved the picture; rotating it is not counted */
  framings = 0;
  /** from the space of the scene to that of what is shown */
  readonly rotation = new THREE.Quaternion();

  constructor(canvas: HTMLCanvasElement) {
    this.controls = new CameraControls(this.camera, canvas);
    this.controls.dollyToCursor = true;
    this.controls.smoothTime = 0.08;
    this.controls.addEventListener('control', () => (this.framings += this.isTurning() ? 0 : 1));
  }

  /** Returns whether the picture has changed. */
  update(seconds: number): boolean {
    return this.controls.update(seconds);
  }

  /** Whether the user is rotating the view, which does not change its framing. */
  private isTurning(): boolean {
    const { ROTATE, TOUCH_ROTATE } = CameraControls.ACTION;
    return ([ROTATE, TOUCH_ROTATE] as number[]).includes(this.controls.currentAction);
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Rotates the camera around the body, in radians. */
  rotate(azimuth: number, polar: number): void {
    void this.controls.rotate(azimuth, polar, true);
  }

  /** Moves the orbit centre, in fractions of its distance. */
  slide(right: number, down: number): void {
    const { distance } = this.controls;
    this.framings += 1;
    void this.controls.truck(right * distance, down * distance, true);
  }

  /** Moves closer by a factor; below 1 away. */
  zoom(factor: number): void {
    this.framings += 1;
    void this.controls.dollyTo(this.controls.distance / factor, true);
  }

  /** Tells the controls in which part of the canvas the pointer is, so that zooming is centred on the cursor. */
  setPointerRegion(left: number, width: number, height: number): void {
    this.controls.setViewport(left, 0, width, height);
  }

  /** Sets the orientation of up, left and front; the next `fit` looks from there. */
  setRotation(rotation: THREE.Quaternion): void {
    if (this.rotation.equals(rotation)) return;
    this.rotation.copy(rotation);
    this.camera.up.set(0, 1, 0).applyQuaternion(rotation);
    this.controls.updateCameraUp();
  }

  /** Frames all of these points, so that they fill the picture. */
  fit(points: readonly THREE.Vector3[], { from, isAnimated }: HowToFit): void {
    const { radius } = new THREE.Box3().setFromPoints([...points]).getBoundingSphere(new THREE.Sphere());
    Object.assign(this.factors, { width: 1, motion: 1 });
    this.camera.near = radius / 100;
    this.camera.far = radius * 100;
    this.controls.maxDistance = radius * FARTHEST;
    this.camera.updateProjectionMatrix();
    const front = new THREE.Vector3(...FRONT).applyQuaternion(this.rotation);
    const framing = new Framing(this.camera, from === 'front' ? front : this.endDirection(), FILL);
    for (const point of points) framing.take(point);
    const { eye, centre } = framing.view();
    void this.controls.setLookAt(...eye.toArray(), ...centre.toArray(), isAnimated);
  }

  /** From the orbit centre towards the place to which the camera moves. */
  private endDirection(): THREE.Vector3 {
    const { controls } = this;
    return controls.getPosition(new THREE.Vector3(), true).sub(controls.getTarget(new THREE.Vector3(), true));
  }

  /** Calls `draw` with the camera rotated about the vertical axis through the orbit centre, in radians. */
  turned(angle: number, draw: () => void): void {
    const { camera } = this;
    const [position, quaternion] = [camera.position.clone(), camera.quaternion.clone()];
    const target = this.controls.getTarget(new THREE.Vector3());
    const rotation = new THREE.Quaternion().setFromAxisAngle(camera.up, angle);
    camera.position.sub(target).applyQuaternion(rotation).add(target);
    camera.quaternion.premultiply(rotation);
    draw();
    camera.position.copy(position);
    camera.quaternion.copy(quaternion);
  }

  /** Sets the camera to `factor` times the distance that the user has chosen, for this reason. */
  stepBack(reason: Reason, factor: number, isAnimated = false): void {
    if (factor === this.factors[reason]) return;
    void this.controls.dollyTo((this.endDistance() * factor) / this.factors[reason], isAnimated);
    this.factors[reason] = factor;
  }

  /** Treats the current distance as chosen by the user. */
  forgetFactor(reason: Reason): void {
    this.factors[reason] = 1;
  }

  /** The current distance over the target distance of the camera. */
  shareOfWay(): number {
    return this.controls.distance / this.endDistance();
  }

  /** The factor on the current distance at which these points, all in front of the camera, extend to `fill` of the picture's width. */
  wayToFit(points: readonly THREE.Vector3[], fill: number): number {
    const tangent = fill * this.camera.aspect * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    const seen = new THREE.Vector3();
    const missing = points.map((point) => {
      seen.copy(point).applyMatrix4(this.camera.matrixWorldInverse);
      return Math.abs(seen.x) / tangent + seen.z;
    });
    return 1 + Math.max(...missing) / this.controls.distance;
  }

  private endDistance(): number {
    return this.controls.getSpherical(new THREE.Spherical(), true).radius;
  }

  /** The largest offsets of the points from the centre of the picture, over half of its width and height; very large for points behind the camera. */
  spreadOf(points: readonly THREE.Vector3[]): { across: number; up: number } {
    this.controls.update(0);
    this.camera.updateMatrixWorld();
    const tangent = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    const seen = new THREE.Vector3();
    const spread = { across: 0, up: 0 };
    for (const point of points) {
      seen.copy(point).applyMatrix4(this.camera.matrixWorldInverse);
      const half = tangent * Math.max(NEAREST, -seen.z);
      spread.across = Math.max(spread.across, Math.abs(seen.x) / (half * this.camera.aspect));
      spread.up = Math.max(spread.up, Math.abs(seen.y) / half);
    }
    return spread;
  }
}
