/** The whole files that panes draw instead of single bodies, their animation, and the floors below. */

import * as THREE from 'three';
import type { Pane } from '../pane';
import type { PaneName } from '../pane_layout';
import { lightByRoom } from '../room_light';
import { SceneModel } from './scene_model';
import type { SceneLook } from './scene_model';

export class ShownFiles {
  private hasFloor = false;
  private isStale = true;
  /** of the scene, in the space of the shown body */
  private outermost: THREE.Vector3[] = [];
  private animation = { isPlaying: false, seconds: 0 };
  /** per pane: the latest requested file */
  private readonly asked: Record<PaneName, Uint8Array | null> = { original: null, optimized: null };
  /** keeps the programs of plain materials, which three.js releases with the last material that uses them */
  private warm: SceneModel | null = null;
  private readonly looks: Record<PaneName, SceneLook | null> = { original: null, optimized: null };

  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly camera: THREE.Camera,
    private readonly panes: Record<PaneName, Pane>,
  ) {}

  /**
   * Draws a whole file, a GLB, in a pane once it has been read; null removes it. Resolves to whether the content of the
   * original's pane has moved. Rejects with the loader's error if it cannot read the file.
   */
  async show(name: PaneName, bytes: Uint8Array | null): Promise<boolean> {
    if (this.asked[name] === bytes) return false;
    this.asked[name] = bytes;
    const pane = this.panes[name];
    const [model] = await Promise.all([bytes && SceneModel.load(bytes), lightByRoom(pane.scene)]);
    if (model) await this.compile(model, name);
    if (this.asked[name] !== bytes) {
      model?.dispose();
      return false;
    }
    const before = boxOf(this.outline());
    pane.stand.show(model);
    this.look(name, this.looks[name]);
    this.moved();
    return name === 'original' && model !== null && !isSameBox(before, boxOf(this.outline()));
  }

  /**
   * Compiles the shader programs for a file, a GLB, and keeps them; `draw` is called once while it is in the original's
   * pane. Does nothing once there is another file.
   */
  async warmUp(bytes: Uint8Array, draw: () => void): Promise<void> {
    const { scene, stand } = this.panes.original;
    const [model] = await Promise.all([SceneModel.load(bytes), lightByRoom(scene)]);
    const isLate = (): boolean => this.asked.original !== null || stand.model !== null;
    if (isLate() || this.warm) return model.dispose();
    this.warm = model;
    await this.compile(model, 'original');
    if (isLate()) return;
    const { hasFloor } = this;
    this.hasFloor = true;
    stand.group.add(model.root);
    draw();
    stand.group.remove(model.root);
    this.hasFloor = hasFloor;
    for (const pane of Object.values(this.panes)) pane.stand.liftFloor();
    this.outermost = [];
  }

  /** Waits until the graphics card is ready to draw a model, if it can report that; otherwise the first drawing blocks the page. */
  private async compile(model: SceneModel, name: PaneName): Promise<void> {
    const look = this.looks[name];
    if (look) model.look(look);
    if (!this.renderer.extensions.has('KHR_parallel_shader_compile')) return;
    await this.renderer.compileAsync(model.root, this.camera, this.panes[name].scene);
  }

  /** How a pane's file is drawn; null: only the body is drawn instead. */
  look(name: PaneName, look: SceneLook | null): void {
    const pane = this.panes[name];
    this.looks[name] = look;
    if (look) pane.stand.look(look);
    pane.showFile(look !== null);
    if (name === 'original') this.moved();
  }

  /** Plays the animation of the files, from its start; false: the rest pose. */
  play(isPlaying: boolean): void {
    if (isPlaying === this.animation.isPlaying) return;
    this.animation = { isPlaying, seconds: 0 };
    for (const { stand } of Object.values(this.panes)) stand.model?.pose(isPlaying ? 0 : null);
  }

  /** Advances the animation; returns whether it plays. */
  advance(seconds: number): boolean {
    const { animation } = this;
    if (!animation.isPlaying) return false;
    animation.seconds += seconds;
    for (const { stand } of Object.values(this.panes)) stand.model?.pose(animation.seconds);
    return true;
  }

  /** Whether what is shown stands on a floor. */
  setFloor(isShown: boolean): void {
    this.hasFloor = isShown;
    for (const { stand } of Object.values(this.panes)) stand.isFloorShown = isShown;
  }

  /** The shown content has changed or moved. */
  moved(): void {
    this.isStale = true;
  }

  /** The outermost points of the original's pane at rest, in the space of the shown body. */
  outline(): readonly THREE.Vector3[] {
    this.layFloors();
    return this.outermost;
  }

  /** Updates the floors if anything has changed since the last time. */
  layFloors(): void {
    if (!this.isStale) return;
    this.isStale = false;
    const { original, optimized } = this.panes;
    this.outermost = original.stand.layFloor(original.showsFile ? null : original.mesh);
    for (const point of this.outermost) point.applyMatrix4(original.stand.group.matrix);
    // The result is so close to the original that its shadow would be the same.
    optimized.stand.shareFloor(original.stand);
    for (const { stand } of [original, optimized]) stand.isFloorShown = this.hasFloor;
  }
}

const boxOf = (points: readonly THREE.Vector3[]): THREE.Box3 => new THREE.Box3().setFromPoints([...points]);

/** Whether two boxes are equal up to the rounding of positions. */
function isSameBox(a: THREE.Box3, b: THREE.Box3): boolean {
  if (a.isEmpty() || b.isEmpty()) return a.isEmpty() === b.isEmpty();
  const most = 1e-3 * a.min.distanceTo(a.max);
  return a.min.distanceTo(b.min) <= most && a.max.distanceTo(b.max) <= most;
}
