/** The camera that all panes share, and how the pointer moves it. */

import CameraControls from 'camera-controls';
import * as THREE from 'three';

CameraControls.install({ THREE });

/** From the body towards the eye, before it is normalised. */
const DIRECTION: [number, number, number] = [0.75, 0.42, 1];
/** The distance of the eye over that at which the bounding sphere just fits. */
const MARGIN = 1.22;
/** Farther away than this many radii a body would be a dot, and then nothing. */
const FARTHEST = 40;

export class OrbitCamera {
  readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  private readonly controls: CameraControls;
  /** how much farther away the eye is than the user has put it */
  private dollyFactor = 1;

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

  /** Tells the controls which part of the canvas the pointer works in, so that zooming goes to the cursor. */
  setPointerRegion(left: number, width: number, height: number): void {
    this.controls.setViewport(left, 0, width, height);
  }

  /** Looks at a whole sphere. */
  fit({ center, radius }: THREE.Sphere, isAnimated: boolean): void {
    this.dollyFactor = 1;
    this.camera.near = radius / 100;
    this.camera.far = radius * 100;
    this.controls.maxDistance = radius * FARTHEST;
    this.camera.updateProjectionMatrix();
    const distance = (MARGIN * radius) / Math.sin(this.narrowHalfAngle());
    const eye = new THREE.Vector3(...DIRECTION).normalize().multiplyScalar(distance).add(center);
    void this.controls.setLookAt(...eye.toArray(), ...center.toArray(), isAnimated);
  }

  /** Puts the eye at `factor` times the distance that the user has chosen. */
  stepBack(factor: number): void {
    void this.controls.dollyTo((this.controls.distance * factor) / this.dollyFactor, false);
    this.dollyFactor = factor;
  }

  /** How far the points go sideways from the middle of the picture, over half of its width. */
  horizontalSpread(points: THREE.Vector3[]): number {
    this.controls.update(0);
    this.camera.updateMatrixWorld();
    return points.reduce((most, point) => Math.max(most, Math.abs(point.project(this.camera).x)), 0);
  }

  /** Half the angle of view along the shorter side of the picture. */
  private narrowHalfAngle(): number {
    const half = THREE.MathUtils.degToRad(this.camera.fov / 2);
    return Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
  }
}
