/** Models that turn together, each in a picture of its own; those that have an animation play it. */

import * as THREE from 'three';
import { SceneModel } from '../app/viewer/file/scene_model';
import type { SceneLook } from '../app/viewer/file/scene_model';
import type { Stage } from './stage';

const HALF_FIELD = Math.tan(THREE.MathUtils.degToRad(15));
/** The share of a picture that its model fills. */
const FILLED = 0.86;
/** Radians for each pixel that the pointer moves. */
const ROTATION = 0.01;
/** How far the eye goes up and down at most, in radians. */
const HIGHEST = 1.4;
const KEYS: Record<string, [number, number]> = {
  ArrowLeft: [-0.15, 0],
  ArrowRight: [0.15, 0],
  ArrowUp: [0, 0.15],
  ArrowDown: [0, -0.15],
};

export class TurningView {
  private readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 1000);
  private readonly centre = new THREE.Vector3();
  private readonly size = new THREE.Vector3();
  private azimuth: number;
  private height = 0.3;
  private isStale = true;

  private constructor(
    private readonly canvases: readonly HTMLCanvasElement[],
    private readonly models: readonly SceneModel[],
  ) {
    const box = new THREE.Box3().setFromObject(models[0].root);
    box.getCenter(this.centre);
    box.getSize(this.size);
    // Bodies that move side by side are seen from the front.
    this.azimuth = this.isMoving ? 0 : 0.45;
    for (const canvas of canvases) this.listen(canvas);
    new ResizeObserver(() => (this.isStale = true)).observe(canvases[0]);
  }

  /** Reads the GLB that each canvas names. Rejects where one is missing. */
  static async load(canvases: readonly HTMLCanvasElement[]): Promise<TurningView> {
    const models = canvases.map(async (canvas) => {
      const response = await fetch(canvas.dataset.model!);
      if (!response.ok) throw new Error(`${canvas.dataset.model}: ${response.status}`);
      return SceneModel.load(new Uint8Array(await response.arrayBuffer()));
    });
    return new TurningView(canvases, await Promise.all(models));
  }

  look(look: SceneLook): void {
    for (const model of this.models) model.look(look);
    this.isStale = true;
  }

  rotate(right: number, up: number): void {
    this.azimuth -= right;
    this.height = THREE.MathUtils.clamp(this.height + up, -HIGHEST, HIGHEST);
    this.isStale = true;
  }

  /** Whether any of them has an animation. */
  get isMoving(): boolean {
    return this.models.some(({ isAnimated }) => isAnimated);
  }

  /** Puts the animations at a time, in seconds. */
  pose(seconds: number): void {
    if (!this.isMoving || !this.isSeen) return;
    for (const model of this.models) model.pose(seconds);
    this.isStale = true;
  }

  /** Draws all, if they are to be seen and anything has changed. */
  draw(stage: Stage): void {
    if (!this.isStale || !this.isSeen) return;
    this.isStale = false;
    const { camera, azimuth, height } = this;
    const distance = this.distance();
    camera.position.setFromSphericalCoords(distance, Math.PI / 2 - height, azimuth).add(this.centre);
    camera.near = distance / 50;
    camera.far = 5 * distance;
    camera.lookAt(this.centre);
    this.canvases.forEach((canvas, i) => stage.draw(canvas, this.models[i].root, camera));
  }

  /** Of the eye, so that the first model fits into its picture however it is turned. */
  private distance(): number {
    const { clientWidth, clientHeight } = this.canvases[0];
    const { x, y, z } = this.size;
    const across = Math.hypot(x, z) / 2;
    const needed = Math.max(y / 2, (across * clientHeight) / Math.max(clientWidth, 1));
    return Math.max(needed / (FILLED * HALF_FIELD) + 0.5 * across, 1e-9);
  }

  private get isSeen(): boolean {
    const { top, bottom } = this.canvases[0].getBoundingClientRect();
    return bottom > 0 && top < innerHeight;
  }

  private listen(canvas: HTMLCanvasElement): void {
    canvas.addEventListener('pointerdown', ({ pointerId }) => canvas.setPointerCapture(pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons) this.rotate(ROTATION * event.movementX, ROTATION * event.movementY);
    });
    canvas.addEventListener('keydown', (event) => {
      const step = KEYS[event.key];
      if (!step) return;
      event.preventDefault();
      this.rotate(...step);
    });
  }
}
