/** The stage: up to two bodies side by side under one camera. It draws meshes and named fields and knows nothing else. */

import CameraControls from 'camera-controls';
import * as THREE from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import type { Levels } from '../../engine/settings/paint_text';
import type { Field } from './body_geometry';
import { BrushRing } from './brush_ring';
import type { BrushMark } from './brush_ring';
import { mapTexture } from './colours';
import type { MapName } from './colours';
import { Pane } from './pane';
import type { Look } from './pane';
import { PinDots } from './pin_dots';
import type { DotLook } from './pin_dots';
import { nearestSeen, seenAt } from './seen_vertices';
import type { ScreenPlace } from './seen_vertices';
import { reachOf } from './twin_props';
import type { Props, PropsLook } from './twin_props';

CameraControls.install({ THREE });

export type PaneName = 'original' | 'optimized';

export class Stage {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
  private readonly controls: CameraControls;
  private readonly timer = new THREE.Timer();
  private readonly maps: Record<MapName, THREE.DataTexture>;
  private readonly panes: Record<PaneName, Pane>;
  private readonly candidate: PinDots;
  private readonly ring = new BrushRing();
  private shown: PaneName[] = ['original'];
  private isOverlaid = false;
  private split: number | null = null;
  private columnsBefore = 1;
  private steppedBack = 1;
  private reach: THREE.Vector3[] = [];
  private stale = true;
  private swinging = false;
  private phase = 0;
  private settle: { amplitude: number; speed: number } = { amplitude: 0, speed: 1 };

  /** Throws where WebGL2 is missing. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    // Panes are cleared all at once.
    this.renderer.autoClear = false;
    this.maps = { viridis: mapTexture('viridis'), cividis: mapTexture('cividis') };
    const ratio = this.renderer.getPixelRatio();
    const pane = (): Pane => new Pane(this.maps.viridis, ratio);
    this.panes = { original: pane(), optimized: pane() };
    this.candidate = new PinDots(ratio);
    this.panes.original.scene.add(this.candidate.points, this.ring.line);
    this.controls = new CameraControls(this.camera, canvas);
    this.controls.dollyToCursor = true;
    this.controls.smoothTime = 0.08;
    for (const name of ['wheel', 'pointerdown'] as const)
      canvas.addEventListener(name, ({ clientX }) => this.aim(clientX), { capture: true, passive: true });
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener('webglcontextrestored', () => (this.stale = true));
    this.resize();
    this.renderer.setAnimationLoop((time) => this.frame(time));
  }

  show(pane: PaneName, mesh: TriangleMesh | null): void {
    this.panes[pane].show(mesh);
    this.stale = true;
  }

  colour(pane: PaneName, field: Field | null, map: MapName): void {
    this.panes[pane].colour(field, this.maps[map]);
    this.stale = true;
  }

  /** Displacement per vertex at full swing, in units of the mesh. */
  displace(pane: PaneName, shape: Float32Array | null): void {
    this.panes[pane].displace(shape);
    this.stale = true;
  }

  /** Vertices of a body in motion, or at rest (null), values to colour them by, and dots at [3 * dot + c]. */
  place(
    name: PaneName,
    positions: Float32Array | null,
    { values = null, dots = null }: { values?: Float32Array | null; dots?: Float32Array | null } = {},
  ): void {
    const pane = this.panes[name];
    pane.place(positions, values);
    if (dots) pane.dots.place(dots);
    this.stale = true;
  }

  /** What bodies fall on. */
  furnish(props: Props | null, look: PropsLook): void {
    for (const pane of Object.values(this.panes)) pane.props.show(props, look);
    this.reach = props ? reachOf(props) : [];
    this.stale = true;
  }

  look(look: Look): void {
    for (const pane of Object.values(this.panes)) pane.look(look);
    this.stale = true;
  }

  /** What a brush has painted on a body; null: nothing. */
  paint(pane: PaneName, levels: Levels | null): void {
    this.panes[pane].paint(levels);
    this.stale = true;
  }

  /** The brush over the original; null takes it away. */
  markBrush(mark: BrushMark | null): void {
    this.ring.show(mark);
    this.stale = true;
  }

  /** Dots at these vertices of the original, at rest. */
  pin(vertices: Iterable<number>): void {
    this.showDots(this.panes.original.dots, vertices);
    this.panes.optimized.dots.place(new Float32Array());
  }

  /** A dot at the vertex that a click would take. */
  offer(vertex: number | null): void {
    this.showDots(this.candidate, vertex === null ? [] : [vertex]);
  }

  private showDots(dots: PinDots, vertices: Iterable<number>): void {
    const { mesh } = this.panes.original;
    dots.show(mesh ?? { positions: new Float32Array(), triangles: new Uint32Array() }, mesh ? vertices : []);
    this.stale = true;
  }

  colourPins(look: DotLook): void {
    for (const pane of Object.values(this.panes)) pane.dots.look(look);
    this.candidate.look({ fill: look.rim, rim: look.fill });
    for (const pane of Object.values(this.panes)) pane.probe.look({ fill: '#ffffff', rim: '#17212b' });
    this.stale = true;
  }

  /** The ray of sight through a place of the page, in the pane that it lies in, or in the one of `fromX`. */
  rayAt(clientX: number, clientY: number, fromX = clientX): THREE.Ray {
    const box = this.canvas.getBoundingClientRect();
    const across = ((clientX - box.left) / box.width) * this.columns - this.columnAt(fromX);
    const place = new THREE.Vector2(2 * across - 1, 1 - (2 * (clientY - box.top)) / box.height);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(place, this.camera);
    return caster.ray;
  }

  /**
   * Side by side; with a colour the later ones as veils over the first; with a split in [0, 1] the first to the left of it
   * and the second to the right.
   */
  arrange(
    shown: PaneName[],
    { veil = null, split = null }: { veil?: string | null; split?: number | null } = {},
  ): void {
    this.shown = shown;
    this.isOverlaid = veil !== null;
    this.split = shown.length === 2 && veil === null ? split : null;
    this.panes.optimized.veil(veil);
    this.panes.original.bare(this.isOverlaid);
    this.makeRoom();
  }

  /** Panes that get narrower do not cut what was seen: the eye steps back, and forth again when they get wider. */
  private makeRoom(): void {
    const before = Math.max(1, this.spread());
    this.resize();
    if (this.columns === this.columnsBefore) return;
    this.columnsBefore = this.columns;
    const back = this.columns > 1 ? Math.max(1, this.spread() / before) : 1;
    void this.controls.dollyTo((this.controls.distance * back) / this.steppedBack, false);
    this.steppedBack = back;
  }

  /** How far the original reaches from the middle of a pane, over half the width of the pane. */
  private spread(): number {
    this.controls.update(0);
    this.camera.updateMatrixWorld();
    return this.panes.original
      .corners()
      .reduce((most, corner) => Math.max(most, Math.abs(corner.project(this.camera).x)), 0);
  }

  private get columns(): number {
    return this.isOverlaid || this.split !== null ? 1 : this.shown.length;
  }

  /** The pane at a place of the page. */
  paneAt(clientX: number): PaneName {
    const { left, width } = this.canvas.getBoundingClientRect();
    if (this.split !== null) return this.shown[(clientX - left) / width < this.split ? 0 : 1];
    return this.shown[this.columnAt(clientX)];
  }

  private columnAt(clientX: number): number {
    const { left, width } = this.canvas.getBoundingClientRect();
    const column = Math.floor(((clientX - left) / width) * this.columns);
    return Math.min(this.columns - 1, Math.max(0, column));
  }

  /** Marks a vertex of a body; null takes the mark away. */
  mark(name: PaneName, vertex: number | null): void {
    this.panes[name].mark(vertex);
    this.stale = true;
  }

  /** The vertex of a pane that is seen nearest to a place of the page, at most `pixels` from it. */
  vertexAt(name: PaneName, { x, y }: ScreenPlace, pixels: number): number | null {
    const body = this.panes[name].seen();
    const box = this.canvas.getBoundingClientRect();
    if (!body || this.paneAt(x) !== name) return null;
    const [place, size] = this.inPane(name, { x: x - box.left, y: y - box.top });
    return nearestSeen(body, this.camera, { ...place, ...size, pixels });
  }

  /** Where a vertex is seen, in pixels from the upper left corner of the canvas. */
  placeOf(name: PaneName, vertex: number): ScreenPlace | null {
    const body = this.panes[name].seen();
    const [origin, size] = this.inPane(name, { x: 0, y: 0 });
    if (!body || 3 * vertex >= body.positions.length) return null;
    const { x, y } = seenAt(body, this.camera, vertex, size);
    return { x: x - origin.x, y: y - origin.y };
  }

  /** A place of the canvas from the corner of a pane, and the size of the pane. */
  private inPane(name: PaneName, { x, y }: ScreenPlace): [ScreenPlace, { width: number; height: number }] {
    const { clientWidth, clientHeight } = this.canvas;
    const width = clientWidth / this.columns;
    const left = this.columns === 1 ? 0 : this.shown.indexOf(name) * width;
    return [
      { x: x - left, y },
      { width, height: clientHeight },
    ];
  }

  /** x = x0 + amplitude sin(theta) phi, Eq. 5; theta runs while `playing`. */
  animate(playing: boolean, amplitude: number, speed: number): void {
    this.swinging = playing;
    this.settle = { amplitude, speed };
    this.stale = true;
  }

  /** Turns the camera to the whole body and to what it can touch. */
  fit(animated = true): void {
    const sphere = this.panes.original.sphere()?.clone();
    for (const point of this.reach) sphere?.expandByPoint(point);
    if (!sphere || !(sphere.radius > 0)) return;
    this.steppedBack = 1;
    this.camera.near = sphere.radius / 100;
    this.camera.far = sphere.radius * 100;
    // Farther away it would be a dot, and then nothing.
    this.controls.maxDistance = sphere.radius * 40;
    this.camera.updateProjectionMatrix();
    const direction = new THREE.Vector3(0.75, 0.42, 1).normalize();
    const distance = (1.22 * sphere.radius) / Math.sin(this.narrowHalfAngle());
    const eye = direction.multiplyScalar(distance).add(sphere.center);
    void this.controls.setLookAt(
      eye.x,
      eye.y,
      eye.z,
      sphere.center.x,
      sphere.center.y,
      sphere.center.z,
      animated,
    );
    this.stale = true;
  }

  /** Zooming goes to the cursor as it lies in its own pane. */
  private aim(clientX: number): void {
    const { width, height } = this.canvas.getBoundingClientRect();
    const share = width / this.columns;
    this.controls.setViewport(this.columnAt(clientX) * share, 0, share, height);
  }

  /** Half the angle of view along the shorter side of a pane. */
  private narrowHalfAngle(): number {
    const half = THREE.MathUtils.degToRad(this.camera.fov / 2);
    return Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / this.columns / clientHeight;
    this.camera.updateProjectionMatrix();
    this.stale = true;
  }

  private frame(time: number): void {
    this.timer.update(time);
    const seconds = this.timer.getDelta();
    const moved = this.controls.update(seconds);
    if (this.swinging) this.phase += 2 * Math.PI * 0.5 * this.settle.speed * seconds;
    if (!moved && !this.stale && !this.swinging) return;
    this.stale = false;
    this.draw();
  }

  private draw(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const width = clientWidth / this.columns;
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.shown.forEach((name, i) => {
      const pane = this.panes[name];
      pane.swing(Math.sin(this.phase) * this.settle.amplitude);
      const left = this.columns === 1 ? 0 : i * width;
      const cut = this.split === null ? null : Math.round(this.split * width);
      this.renderer.setViewport(left, 0, width, clientHeight);
      if (cut === null) this.renderer.setScissor(left, 0, width, clientHeight);
      else this.renderer.setScissor(i * cut, 0, i === 0 ? cut : width - cut, clientHeight);
      // A veil is not hidden by what it lies over.
      if (this.isOverlaid && i > 0) {
        this.renderer.clearDepth();
        pane.drawDepth(() => this.renderer.render(pane.scene, this.camera));
      }
      this.renderer.render(pane.scene, this.camera);
    });
  }
}
