/** The camera that all panes share, and how the pointer moves it. */

import CameraControls from 'camera-controls';
import * as THREE from 'three';

CameraControls.install({ THREE });

/** From the body towards the eye, before it is normalised. */
const DIRECTION: [number, number, number] = [0.75, 0.42, 1];
/** The share of the picture's height and width that a body fills, at most. */
const FILL = 0.8;
/** Farther away than this many radii a body would be a dot, and then nothing. */
const FARTHEST = 40;

export class OrbitCamera {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  private readonly controls: CameraControls;
  /** how much farther away the eye is than the user has put it */
  private dollyFactor = 1;
  /** from the space of the scene to that of what is shown */
  readonly rotation = new THREE.Quaternion();

  constructor(canvas: HTMLCanvasElement) {
    this.controls = new CameraControls(this.camera, canvas);
    this.controls.dollyToCursor = true;
    this.controls.smoothTime = 0.08;
  }

  /** Returns whether the picture has changed. */
  update(seconds: number): boolean {
    return this.controls.update(seconds);
  }

  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Turns the eye around the body, in radians. */
  rotate(azimuth: number, polar: number): void {
    void this.controls.rotate(azimuth, polar, true);
  }

  /** Moves what is looked at, in shares of its distance. */
  slide(right: number, down: number): void {
    const { distance } = this.controls;
    void this.controls.truck(right * distance, down * distance, true);
  }

  /** Comes nearer by a factor; below 1 it goes away. */
  zoom(factor: number): void {
    void this.controls.dollyTo(this.controls.distance / factor, true);
  }

  /** Tells the controls which part of the canvas the pointer works in, so that zooming goes to the cursor. */
  setPointerRegion(left: number, width: number, height: number): void {
    this.controls.setViewport(left, 0, width, height);
  }

  /** Turns what is up, left and in front; the next `fit` looks from there. */
  setRotation(rotation: THREE.Quaternion): void {
    if (this.rotation.equals(rotation)) return;
    this.rotation.copy(rotation);
    this.camera.up.set(0, 1, 0).applyQuaternion(rotation);
    this.controls.updateCameraUp();
  }

  /** Looks at all of these points from the front, so near that they fill the picture. */
  fit(points: THREE.Vector3[], isAnimated: boolean): void {
    const { center, radius } = new THREE.Box3().setFromPoints(points).getBoundingSphere(new THREE.Sphere());
    this.dollyFactor = 1;
    this.camera.near = radius / 100;
    this.camera.far = radius * 100;
    this.controls.maxDistance = radius * FARTHEST;
    this.camera.updateProjectionMatrix();
    const back = new THREE.Vector3(...DIRECTION).normalize().applyQuaternion(this.rotation);
    const eye = back
      .clone()
      .multiplyScalar(this.distanceFor(points, center, back))
      .add(center);
    void this.controls.setLookAt(...eye.toArray(), ...center.toArray(), isAnimated);
  }

  /** How far from `center` the eye has to be, towards `back`, for all points to lie in the picture. */
  private distanceFor(points: THREE.Vector3[], center: THREE.Vector3, back: THREE.Vector3): number {
    const right = this.camera.up.clone().cross(back).normalize();
    const above = back.clone().cross(right);
    const tangent = FILL * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
    return points.reduce((most, point) => {
      const from = point.clone().sub(center);
      const aside = Math.abs(from.dot(right)) / (tangent * this.camera.aspect);
      return Math.max(most, from.dot(back) + Math.max(aside, Math.abs(from.dot(above)) / tangent));
    }, 0);
  }

  /** Calls `draw` with the eye turned about the upright axis through what it looks at, in radians. */
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

  /** Puts the eye at `factor` times the distance that the user has chosen. */
  stepBack(factor: number): void {
    void this.controls.dollyTo((this.controls.distance * factor) / this.dollyFactor, false);
    this.dollyFactor = factor;
  }

  /** How far the points go sideways from the middle of the picture, over half of its width. */
  horizontalSpread(points: readonly THREE.Vector3[]): number {
    this.controls.update(0);
    this.camera.updateMatrixWorld();
    return points.reduce((most, point) => Math.max(most, Math.abs(point.clone().project(this.camera).x)), 0);
  }
}
