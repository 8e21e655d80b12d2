/** The hand that works on the vertices of the shown mesh: a click takes one or the disc around it, a drag goes over many. */

import type { Ray } from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import { Picker } from './picker';
import type { PickedVertex } from './picker';

/** What the tool needs to know and whom it tells. */
export interface PickHost {
  /** null: the tool is not in use, or nothing is shown */
  mesh(): TriangleMesh | null;
  /** null where the place shows another mesh */
  rayAt(clientX: number, clientY: number): Ray | null;
  /** radius of the brush, in units of the mesh */
  brush(): number;
  /** whether a click takes the whole disc of the brush, not one vertex */
  isBroad(): boolean;
  /** what a click would take; null where there is nothing */
  hover(picked: PickedVertex | null): void;
  /** while a stroke goes on */
  paint(stroke: Stroke): void;
  /** the end of a stroke */
  finish(stroke: Stroke): void;
}

export interface Stroke {
  /** the vertices that it has touched: the least distance from the middle of the brush, over its radius */
  readonly vertices: ReadonlyMap<number, number>;
  readonly isErasing: boolean;
  /** without a drag */
  readonly isClick: boolean;
}

interface OwnStroke extends Stroke {
  pointer: number;
  startX: number;
  startY: number;
  /** where it was touched last */
  lastX: number;
  lastY: number;
  isClick: boolean;
  vertices: Map<number, number>;
}

interface Place {
  clientX: number;
  clientY: number;
}

/** A hand that moves less than this, in pixels, meant a click. */
const CLICK_PIXELS = 4;
/** A quick hand is followed in steps of this, so that its stroke has no gaps. */
const STEP_PIXELS = 6;

export class PickTool {
  private picker: { mesh: TriangleMesh; tree: Picker | null } | null = null;
  private stroke: OwnStroke | null = null;
  private hovered: number | null = null;

  /** Listens on the canvas ahead of the camera, which gets every drag that does not begin on the body. */
  constructor(
    canvas: HTMLCanvasElement,
    private readonly host: PickHost,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.begin(event, canvas), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.end(event));
    canvas.addEventListener('pointercancel', () => this.abandon());
    canvas.addEventListener('pointerleave', () => this.hover(null));
  }

  /** Forgets a stroke that has not ended. */
  abandon(): void {
    this.stroke = null;
  }

  /** Makes ready for the mesh that is shown now, as its tree may take a while. */
  prepare(): void {
    this.tree();
  }

  private begin(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (event.button !== 0 || this.stroke) return;
    const picked = this.pickedAt(event);
    if (!picked) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(event.pointerId);
    const { clientX, clientY } = event;
    this.stroke = {
      pointer: event.pointerId,
      startX: clientX,
      startY: clientY,
      lastX: clientX,
      lastY: clientY,
      isErasing: event.shiftKey,
      isClick: true,
      vertices: new Map([[picked.vertex, 0]]),
    };
    if (!this.host.isBroad()) return;
    this.touch(this.stroke, event);
    this.host.paint(this.stroke);
  }

  private move(event: PointerEvent): void {
    const { stroke } = this;
    // A button that is held down turns the view, or paints under the mark.
    if (event.buttons === 0 || stroke) this.hover(this.pickedAt(event));
    if (!stroke || event.pointerId !== stroke.pointer) return;
    const distance = Math.hypot(event.clientX - stroke.startX, event.clientY - stroke.startY);
    if (stroke.isClick && distance < CLICK_PIXELS) return;
    stroke.isClick = false;
    this.touchOnTheWay(stroke, event);
    this.host.paint(stroke);
  }

  private end(event: PointerEvent): void {
    const { stroke } = this;
    if (!stroke || event.pointerId !== stroke.pointer) return;
    this.stroke = null;
    this.host.finish(stroke);
  }

  private hover(picked: PickedVertex | null): void {
    const vertex = picked?.vertex ?? null;
    if (vertex === this.hovered && !this.host.isBroad()) return;
    this.hovered = vertex;
    this.host.hover(picked);
  }

  private touchOnTheWay(stroke: OwnStroke, { clientX, clientY }: Place): void {
    const { lastX, lastY } = stroke;
    const steps = Math.ceil(Math.hypot(clientX - lastX, clientY - lastY) / STEP_PIXELS);
    for (let step = 1; step <= steps; step++) {
      const part = step / steps;
      this.touch(stroke, {
        clientX: lastX + part * (clientX - lastX),
        clientY: lastY + part * (clientY - lastY),
      });
    }
    Object.assign(stroke, { lastX: clientX, lastY: clientY });
  }

  private touch({ vertices }: OwnStroke, place: Place): void {
    const picked = this.pickedAt(place);
    if (!picked) return;
    const radius = this.host.brush();
    for (const [vertex, distance] of this.tree()!.around(picked.point, radius))
      vertices.set(vertex, Math.min(distance / radius, vertices.get(vertex) ?? 1));
  }

  private pickedAt({ clientX, clientY }: Place): PickedVertex | null {
    const tree = this.tree();
    const ray = tree && this.host.rayAt(clientX, clientY);
    return ray ? tree.underRay(ray) : null;
  }

  /** Of the shown mesh, made when it is first needed; null until it is there. */
  private tree(): Picker | null {
    const mesh = this.host.mesh();
    if (!mesh) return null;
    if (this.picker?.mesh !== mesh) this.grow(mesh);
    return this.picker!.tree;
  }

  private grow(mesh: TriangleMesh): void {
    const found = Picker.of(mesh);
    this.picker = { mesh, tree: found instanceof Picker ? found : null };
    if (found instanceof Picker) return;
    void found.then((tree) => {
      if (this.picker?.mesh === mesh) this.picker.tree = tree;
    });
  }
}
