/** The viewport: up to two bodies under one camera. It draws meshes and named fields and has no further knowledge of the page. */

import * as THREE from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import type { Levels } from '../../engine/settings/paint_text';
import type { Field } from './body_geometry';
import type { BrushMark } from './brush_ring';
import { pointsToShow } from './collision_scene_view';
import type { CollisionSceneLook, ShownCollisionScene } from './collision_scene_view';
import { mapTexture } from './colours';
import type { MapName } from './colours';
import { AxesMark } from './axes_mark';
import { Dots } from './dots';
import type { DotLook } from './dots';
import { drawPane } from './draw_pane';
import { FrameKeeper } from './camera/frame_keeper';
import { OrbitCamera } from './camera/orbit_camera';
import type { HowToFit } from './camera/orbit_camera';
import { Pane } from './pane';
import type { Look } from './pane';
import { PaneLayout } from './pane_layout';
import type { PaneName } from './pane_layout';
import type { SceneLook } from './file/scene_model';
import { nearestSeen, seenAt } from './seen_vertices';
import type { ScreenPoint } from './seen_vertices';
import { drawAtSize } from './picture/stage_shot';
import type { StageShot } from './picture/stage_shot';
import { ShownFiles } from './file/shown_files';
import { warmUp } from './file/warm_up';
import { standingMatrix, standingRotation } from './stand';

/** Swings per second at speed 1. */
const SWING_FREQUENCY = 0.5;

export class Viewport {
  private readonly renderer: THREE.WebGLRenderer;
  readonly orbit: OrbitCamera;
  private readonly layout: PaneLayout;
  private readonly keeper: FrameKeeper;
  private readonly timer = new THREE.Timer();
  private readonly maps: Record<MapName, THREE.DataTexture>;
  private readonly panes: Record<PaneName, Pane>;
  private readonly pickPreview: Dots;
  /** vertices of the original */
  private pinned: Iterable<number> = [];
  /** whether the camera waits for a large mesh */
  private fitsLater = false;
  private scenePoints: THREE.Vector3[] = [];
  private readonly axes = new AxesMark();
  private readonly files: ShownFiles;
  private isStale = true;
  /** whether time is frozen between pictures of a recording */
  isRecording = false;
  private swing = { isPlaying: false, amplitude: 0, speed: 1, phase: 0 };

  /** Throws if WebGL2 is missing. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    // All panes are cleared at once.
    this.renderer.autoClear = false;
    // Checking for errors would wait for the graphics card.
    this.renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.maps = { viridis: mapTexture('viridis'), cividis: mapTexture('cividis') };
    const ratio = this.renderer.getPixelRatio();
    const pane = (): Pane => new Pane(this.maps.viridis, ratio, () => (this.isStale = true));
    this.panes = { original: pane(), optimized: pane() };
    this.pickPreview = new Dots(ratio);
    this.panes.original.scene.add(this.pickPreview.points);
    this.orbit = new OrbitCamera(canvas);
    this.keeper = new FrameKeeper(this.orbit);
    this.files = new ShownFiles(this.renderer, this.orbit.camera, this.panes);
    this.layout = new PaneLayout(canvas);
    const aim = (event: MouseEvent): void => this.orbit.setPointerRegion(...this.layout.columnRegion(event));
    for (const name of ['wheel', 'pointerdown'] as const)
      canvas.addEventListener(name, aim, { capture: true, passive: true });
    // A canvas is cleared when its size changes, so it has to be redrawn before the browser shows it.
    new ResizeObserver(() => {
      this.keepBodyInView();
      this.draw();
    }).observe(canvas);
    canvas.addEventListener('webglcontextrestored', () => {
      this.renderer.setClearAlpha(0); // three.js starts again with an opaque black
      this.isStale = true;
    });
    this.resize();
    this.renderer.setAnimationLoop((time) => this.frame(time));
  }

  /** Shows a mesh at rest in a pane; null empties the pane. */
  show(name: PaneName, mesh: TriangleMesh | null): void {
    const isShown = this.panes[name].show(mesh);
    this.follow(name);
    void isShown?.then(() => {
      this.follow(name);
      if (name === 'original') this.pin(this.pinned);
      if (name === 'original' && this.fitsLater) this.fit('front');
    });
  }

  /** The content of a pane has changed. */
  private follow(name: PaneName): void {
    if (name === 'original') this.files.moved();
    this.isStale = true;
  }

  /** See `ShownFiles.show`. */
  async showFile(name: PaneName, bytes: Uint8Array | null): Promise<void> {
    const isElsewhere = await this.files.show(name, bytes);
    this.isStale = true;
    if (isElsewhere) this.fit('front');
  }

  /** See file/warm_up.ts. */
  warmUp = (): Promise<void> => warmUp(this.files, this.panes.original, () => this.draw());

  /** How a pane's file is drawn; null: only the body is drawn instead. */
  lookAtFile(name: PaneName, look: SceneLook | null): void {
    this.files.look(name, look);
    this.isStale = true;
  }

  /** Plays the animation of the files, from its start; false: the rest pose. */
  playFile(isPlaying: boolean): void {
    this.files.play(isPlaying);
    this.isStale = true;
  }

  /** Sets the matrix from the shown body to its scene, column by column. */
  standAt(nodeMatrix: readonly number[]): void {
    const matrix = standingMatrix(nodeMatrix);
    const rotation = standingRotation(nodeMatrix);
    this.orbit.setRotation(rotation);
    for (const { stand, collisionScene } of Object.values(this.panes)) {
      stand.standAt(matrix);
      collisionScene.group.quaternion.copy(rotation);
    }
    this.files.moved();
    this.isStale = true;
  }

  /** Whether what is shown stands on a floor. */
  setFloor(isShown: boolean): void {
    this.files.setFloor(isShown);
    this.isStale = true;
  }

  /** Colours a body by a field; null leaves it plain. */
  colour(name: PaneName, field: Field | null, map: MapName): void {
    this.panes[name].colour(field, this.maps[map]);
    this.isStale = true;
  }

  /** `shape[3 v + c]`: displacement at full swing over the amplitude. */
  displace(name: PaneName, shape: Float32Array | null): void {
    this.panes[name].displace(shape);
    this.isStale = true;
  }

  /** Moves the vertices of a body, or returns them to rest (null). `values[v]` in [0, 1] colour it; `dots[3 i + c]`: positions of dots. */
  setPositions(
    name: PaneName,
    positions: Float32Array | null,
    { values = null, dots = null }: { values?: Float32Array | null; dots?: Float32Array | null } = {},
  ): void {
    const pane = this.panes[name];
    pane.setPositions(positions, values);
    if (dots) pane.dots.setPoints(dots);
    this.isStale = true;
  }

  /** Shows the collision scene; null shows nothing. */
  setCollisionScene(scene: ShownCollisionScene | null, look: CollisionSceneLook): void {
    for (const pane of Object.values(this.panes)) pane.collisionScene.show(scene, look);
    this.scenePoints = scene ? pointsToShow(scene) : [];
    this.isStale = true;
  }

  look(look: Look): void {
    for (const pane of Object.values(this.panes)) pane.look(look);
    this.isStale = true;
  }

  /** Shows the paint of a brush on a body; null shows nothing. */
  paint(name: PaneName, levels: Levels | null): void {
    this.panes[name].paint(levels);
    this.isStale = true;
  }

  /** Shows the outline of the brush on the original, and at the same position on the optimized mesh; null hides it. */
  markBrush(mark: BrushMark | null): void {
    for (const pane of Object.values(this.panes)) pane.ring.show(mark);
    this.isStale = true;
  }

  /** Shows dots at these vertices of the original at rest. */
  pin(vertices: Iterable<number>): void {
    this.pinned = vertices;
    this.showDots(this.panes.original.dots, vertices);
    this.panes.optimized.dots.setPoints(new Float32Array());
  }

  /** Shows a dot at the vertex that a click would pick; null hides it. */
  previewPick(vertex: number | null): void {
    this.showDots(this.pickPreview, vertex === null ? [] : [vertex]);
  }

  private showDots(dots: Dots, vertices: Iterable<number>): void {
    const { mesh } = this.panes.original;
    dots.show(mesh ?? { positions: new Float32Array(), triangles: new Uint32Array() }, mesh ? vertices : []);
    this.isStale = true;
  }

  colourPins(look: DotLook): void {
    for (const pane of Object.values(this.panes)) pane.dots.look(look);
    this.pickPreview.look({ fill: look.rim, rim: look.fill });
    for (const pane of Object.values(this.panes)) pane.hoverDot.look({ fill: '#ffffff', rim: '#17212b' });
    this.isStale = true;
  }

  /** Marks a vertex of a body; null removes the mark. */
  mark(name: PaneName, vertex: number | null): void {
    this.panes[name].mark(vertex);
    this.isStale = true;
  }

  /**
   * Arranges the panes side by side; with an overlay colour the second is drawn translucent over the first; with a
   * split in [0, 1] the first is visible to the left of it and the second to the right.
   */
  arrange(
    panes: readonly PaneName[],
    { overlay = null, split = null }: { overlay?: string | null; split?: number | null } = {},
  ): void {
    this.layout.arrange(panes, { isOverlaid: overlay !== null, split });
    this.panes.optimized.overlay(overlay);
    this.panes.original.hideWires(overlay !== null);
    this.keepBodyInView();
  }

  private keepBodyInView = (): void => this.keeper.keepWidth(this.framedPoints(), () => this.resize());

  /** Keeps moving bodies in the picture, unless the user drags one; null: they rest again. `positions[3 v + c]` of each. */
  followMotion(bodies: readonly Float32Array[] | null): void {
    if (!bodies) this.keeper.endMotion();
    else if (!this.canvas.classList.contains('dragging'))
      this.keeper.keepMotion(this.files.outline(), bodies);
  }

  /** The pane at a point of the page. */
  paneAt(clientX: number): PaneName {
    return this.layout.paneAt(clientX);
  }

  /** The viewing ray through a point of the page, in the pane that contains `fromX`. */
  rayAt(clientX: number, clientY: number, fromX = clientX): THREE.Ray {
    const caster = new THREE.Raycaster();
    caster.setFromCamera(this.layout.deviceCoordinates(clientX, clientY, fromX), this.orbit.camera);
    return caster.ray;
  }

  /** The visible vertex of a pane that is nearest to a point of the page, at most `pixels` from it. */
  vertexAt(name: PaneName, point: ScreenPoint, pixels: number): number | null {
    const body = this.panes[name].seen();
    if (!body || this.paneAt(point.x) !== name) return null;
    const target = { ...this.layout.toPane(name, point), ...this.layout.paneSize, pixels };
    return nearestSeen(body, this.orbit.camera, target);
  }

  /** The position of a vertex on the screen, in pixels from the upper left corner of the canvas. */
  screenPointOf(name: PaneName, vertex: number): ScreenPoint | null {
    const body = this.panes[name].seen();
    if (!body || 3 * vertex >= body.positions.length) return null;
    return this.layout.toCanvas(name, seenAt(body, this.orbit.camera, vertex, this.layout.paneSize));
  }

  /** x = x0 + amplitude sin(theta) phi, Eq. 5; theta advances while `isPlaying`. */
  animate(isPlaying: boolean, amplitude: number, speed: number): void {
    Object.assign(this.swing, { isPlaying, amplitude, speed });
    this.isStale = true;
  }

  /** Frames the camera on the whole body and the collision scene: at once from the front, or moving without a turn. */
  fit(from: HowToFit['from']): void {
    this.fitsLater = this.panes.original.isLate;
    const points = this.framedPoints();
    if (this.fitsLater || points.length === 0) return;
    this.orbit.fit(points, { from, isAnimated: from === 'here' });
    this.keeper.fitted();
    this.isStale = true;
  }

  private framedPoints = (): THREE.Vector3[] =>
    this.files.outline().concat(this.scenePoints.map((p) => p.clone().applyQuaternion(this.orbit.rotation)));

  /** Draws the current stage at any size, and passes on the canvas before anything else is drawn on it. */
  capture(shot: StageShot, use: (canvas: HTMLCanvasElement) => void): void {
    const { renderer, layout, orbit, panes } = this;
    this.advance(shot.seconds ?? 0);
    drawAtSize({ renderer, layout, orbit, panes }, shot, (isLast) => {
      this.resize();
      this.draw(shot.hasAxes || isLast);
      if (!isLast) use(this.canvas);
    });
  }

  /** Advances the time of animations; returns whether the files' animation plays. */
  private advance(seconds: number): boolean {
    const { swing } = this;
    if (swing.isPlaying) swing.phase += 2 * Math.PI * SWING_FREQUENCY * swing.speed * seconds;
    return this.files.advance(seconds);
  }

  private resize(): void {
    const { width, height } = this.layout.canvasSize;
    if (width === 0 || height === 0) return;
    const size = this.renderer.getSize(new THREE.Vector2());
    // Setting the size of a canvas, even to the same value, waits for all pending drawing.
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.orbit.setAspect(width / this.layout.columns / height);
    this.isStale = true;
  }

  private frame(time: number): void {
    this.timer.update(time);
    const seconds = this.timer.getDelta();
    const hasMoved = this.orbit.update(seconds);
    if (this.isRecording) return;
    const isPlaying = this.advance(seconds);
    if (!hasMoved && !this.isStale && !this.swing.isPlaying && !isPlaying) return;
    this.isStale = false;
    this.draw();
  }

  private draw(hasAxes = true): void {
    this.files.layFloors();
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const displacement = Math.sin(this.swing.phase) * this.swing.amplitude;
    this.layout.regions().forEach((region, i) => {
      this.panes[region.name].swing(displacement);
      const isOverlay = this.layout.isOverlaid && i > 0;
      drawPane(this.renderer, this.orbit.camera, this.panes[region.name], { ...region, isOverlay });
    });
    if (hasAxes && this.panes.original.mesh)
      this.axes.draw(this.renderer, this.orbit.camera, this.orbit.rotation);
  }
}
