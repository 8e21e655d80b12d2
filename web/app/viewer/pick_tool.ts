/** The hand that pins vertices: a click takes the vertex under the cursor, a drag paints. */

import type { Ray } from 'three';
import type { TriangleMesh } from '../../engine/core';
import { Picker } from './picker';

/** What the tool needs to know and whom it tells. */
export interface PickHost {
  /** null: the tool is not in use, or nothing is shown */
  mesh(): TriangleMesh | null;
  rayAt(clientX: number, clientY: number): Ray;
  /** radius of the brush, in units of the mesh */
  brush(): number;
  /** the vertex that a click would take; null where there is none */
  hover(vertex: number | null): void;
  /** while a stroke goes on: the vertices that it has touched */
  paint(vertices: ReadonlySet<number>, isErasing: boolean): void;
  /** the end of a stroke; `isClick`: of one vertex, without a drag */
  finish(vertices: number[], isErasing: boolean, isClick: boolean): void;
}

interface Stroke {
  pointer: number;
  startX: number;
  startY: number;
  isErasing: boolean;
  isClick: boolean;
  vertices: Set<number>;
}

/** A hand that moves less than this, in pixels, meant a click. */
const CLICK_PIXELS = 4;

export class PickTool {
  private picker: { mesh: TriangleMesh; tree: Picker } | null = null;
  private stroke: Stroke | null = null;
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

  private begin(event: PointerEvent, canvas: HTMLCanvasElement): void {
    if (event.button !== 0 || this.stroke) return;
    const vertex = this.vertexAt(event);
    if (vertex === null) return;
    event.stopImmediatePropagation();
    canvas.setPointerCapture(event.pointerId);
    this.stroke = {
      pointer: event.pointerId,
      startX: event.clientX,
      startY: event.clientY,
      isErasing: event.shiftKey,
      isClick: true,
      vertices: new Set([vertex]),
    };
  }

  private move(event: PointerEvent): void {
    const { stroke } = this;
    // A button that is held down turns the view.
    if (!stroke && event.buttons === 0) this.hover(this.vertexAt(event));
    if (!stroke || event.pointerId !== stroke.pointer) return;
    const distance = Math.hypot(event.clientX - stroke.startX, event.clientY - stroke.startY);
    if (stroke.isClick && distance < CLICK_PIXELS) return;
    stroke.isClick = false;
    for (const at of event.getCoalescedEvents?.() ?? [event]) this.touch(stroke, at);
    this.host.paint(stroke.vertices, stroke.isErasing);
  }

  private end(event: PointerEvent): void {
    const { stroke } = this;
    if (!stroke || event.pointerId !== stroke.pointer) return;
    this.stroke = null;
    this.host.finish([...stroke.vertices], stroke.isErasing, stroke.isClick);
  }

  private hover(vertex: number | null): void {
    if (vertex === this.hovered) return;
    this.hovered = vertex;
    this.host.hover(vertex);
  }

  private touch({ vertices }: Stroke, { clientX, clientY }: PointerEvent): void {
    const tree = this.tree();
    const picked = tree?.underRay(this.host.rayAt(clientX, clientY));
    if (tree && picked)
      for (const vertex of tree.around(picked.point, this.host.brush())) vertices.add(vertex);
  }

  private vertexAt({ clientX, clientY }: PointerEvent): number | null {
    return this.tree()?.underRay(this.host.rayAt(clientX, clientY))?.vertex ?? null;
  }

  /** Of the shown mesh, made when it is first needed. */
  private tree(): Picker | null {
    const mesh = this.host.mesh();
    if (!mesh) return null;
    if (this.picker?.mesh !== mesh) this.picker = { mesh, tree: new Picker(mesh) };
    return this.picker.tree;
  }
}
