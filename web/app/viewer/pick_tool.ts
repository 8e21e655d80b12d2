/** The tool that picks vertices of the shown mesh: a click picks one or the disc around it, a drag picks many. */

import type { Ray } from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import type { Stroke } from '../stroke';
import { Picker } from './picker';
import type { PickedVertex } from './picker';

/** The action on the picked vertices. */
export interface StrokeTool {
  /** radius of the brush, in units of the mesh */
  radius(): number;
  /** what a click would pick; null if there is nothing */
  hover(picked: PickedVertex | null): void;
  /** called during a stroke */
  paint(stroke: Stroke): void;
  /** called at the end of a stroke */
  finish(stroke: Stroke): void;
}

/** What the tool needs of the page. */
export interface PickHost {
  /** its current action; null: it is not in use */
  tool(): StrokeTool | null;
  /** null: no mesh is shown that it could work on */
  mesh(): TriangleMesh | null;
  /** through the picture that contains `fromX`, the start of the stroke; null if the tool does not work there */
  rayAt(clientX: number, clientY: number, fromX: number): Ray | null;
  /** whether a click picks the whole disc of the brush, not one vertex */
  isBroad(): boolean;
  /** called if nothing can be picked on the mesh until `prepare` is called again */
  fail(error: unknown): void;
}

interface RunningStroke extends Stroke {
  tool: StrokeTool;
  pointer: number;
  startX: number;
  startY: number;
  /** the last touched point of the page */
  lastX: number;
  lastY: number;
  isClick: boolean;
  vertices: Map<number, number>;
}

type PagePoint = Pick<PointerEvent, 'clientX' | 'clientY'>;

/** A press that moves less than this, in pixels, is a click. */
const CLICK_PIXELS = 4;
/** A fast pointer is sampled in steps of this size, so that its stroke has no gaps. */
const STEP_PIXELS = 6;

export class PickTool {
  private picker: { mesh: TriangleMesh; tree: Picker | null; hasFailed?: true } | null = null;
  private stroke: RunningStroke | null = null;
  private hovered: number | null = null;

  /** Listens on the canvas before the camera, which gets every drag that does not begin on the body. */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly host: PickHost,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.onPress(event, canvas), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    canvas.addEventListener('pointerup', (event) => this.onRelease(event));
    canvas.addEventListener('pointercancel', (event) => this.onCancel(event));
    canvas.addEventListener('pointerleave', () => this.hover(null));
  }

  /** Starts to build the search tree of the shown mesh, which may take a while; after a failure it is built again. */
  prepare(): void {
    if (this.picker?.hasFailed) this.picker = null;
    this.tree();
  }

  /** Shows what a click at a point of the page would pick. */
  aim(point: PagePoint): void {
    this.hover(this.pickedAt(point));
  }

  /** A click at a point of the page, triggered by the keyboard. */
  click(point: PagePoint, isErasing: boolean): void {
    const stroke = this.begin(point, isErasing, -1);
    if (!stroke) return;
    if (this.host.isBroad()) this.touch(stroke, point);
    stroke.tool.finish(stroke);
  }

  /** Null if there is nothing under the point. */
  private begin(point: PagePoint, isErasing: boolean, pointer: number): RunningStroke | null {
    const picked = this.pickedAt(point);
    const tool = this.host.tool();
    if (!picked || !tool) return null;
    const { clientX, clientY } = point;
    const at = { startX: clientX, startY: clientY, lastX: clientX, lastY: clientY };
    return { tool, pointer, ...at, isErasing, isClick: true, vertices: new Map([[picked.vertex, 0]]) };
  }

  /** Whether a stroke is in progress. A stroke is dropped if its tool has been switched off meanwhile. */
  private isStroking(): boolean {
    if (this.stroke && this.stroke.tool !== this.host.tool()) this.stroke = null;
    return this.stroke !== null;
  }

  private strokeOf(event: PointerEvent): RunningStroke | null {
    return this.isStroking() && this.stroke!.pointer === event.pointerId ? this.stroke : null;
  }

  private onPress(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (event.button !== 0 || this.isStroking()) return;
    const stroke = (this.stroke = this.begin(event, event.shiftKey, event.pointerId));
    if (!stroke) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(event.pointerId);
    if (!this.host.isBroad()) return;
    this.touch(stroke, event);
    stroke.tool.paint(stroke);
  }

  private onMove(event: PointerEvent): void {
    const stroke = this.strokeOf(event);
    // With a button down and no stroke the pointer rotates the view and does not hover.
    if (event.buttons === 0 || this.stroke) this.hover(this.pickedAt(event));
    if (!stroke) return;
    const distance = Math.hypot(event.clientX - stroke.startX, event.clientY - stroke.startY);
    if (stroke.isClick && distance < CLICK_PIXELS) return;
    stroke.isClick = false;
    this.touchOnTheWay(stroke, event);
    stroke.tool.paint(stroke);
  }

  private onRelease(event: PointerEvent): void {
    const stroke = this.strokeOf(event);
    if (!stroke) return;
    this.stroke = null;
    stroke.tool.finish(stroke);
  }

  /** The stroke is undone, as if it had touched nothing. */
  private onCancel(event: PointerEvent): void {
    const stroke = this.strokeOf(event);
    if (!stroke) return;
    this.stroke = null;
    stroke.tool.paint({ ...stroke, vertices: new Map() });
  }

  private hover(picked: PickedVertex | null): void {
    const vertex = picked?.vertex ?? null;
    if (vertex === this.hovered && !this.host.isBroad()) return;
    this.hovered = vertex;
    this.host.tool()?.hover(picked);
  }

  private touchOnTheWay(stroke: RunningStroke, { clientX, clientY }: PagePoint): void {
    const { lastX, lastY } = stroke;
    const steps = Math.ceil(Math.hypot(clientX - lastX, clientY - lastY) / STEP_PIXELS);
    for (let step = 1; step <= steps; step++) {
      const share = step / steps;
      this.touch(stroke, {
        clientX: lastX + share * (clientX - lastX),
        clientY: lastY + share * (clientY - lastY),
      });
    }
    Object.assign(stroke, { lastX: clientX, lastY: clientY });
  }

  private touch({ tool, vertices }: RunningStroke, point: PagePoint): void {
    const picked = this.pickedAt(point);
    if (!picked) return;
    const radius = tool.radius();
    for (const [vertex, distance] of this.tree()!.around(picked.point, radius))
      vertices.set(vertex, Math.min(distance / radius, vertices.get(vertex) ?? 1));
  }

  private pickedAt({ clientX, clientY }: PagePoint): PickedVertex | null {
    const tree = this.tree();
    const ray = tree && this.host.rayAt(clientX, clientY, this.stroke?.startX ?? clientX);
    return ray ? tree.underRay(ray) : null;
  }

  /** The search tree of the shown mesh, built when it is first needed; null until it is ready. */
  private tree(): Picker | null {
    const mesh = this.host.mesh();
    if (!mesh) return null;
    if (this.picker?.mesh !== mesh) this.build(mesh);
    return this.picker!.tree;
  }

  private build(mesh: TriangleMesh): void {
    const found = Picker.of(mesh);
    if (found instanceof Picker) {
      this.picker = { mesh, tree: found };
      return;
    }
    const own = (this.picker = { mesh, tree: null });
    found.then(
      (tree) => Object.assign(own, { tree }),
      (error: unknown) => {
        Object.assign(own, { hasFailed: true });
        if (this.picker === own) this.host.fail(error);
      },
    );
  }
}
