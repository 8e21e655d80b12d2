/** The hand that pulls at a moving body: where a ray meets it, and where the hand then goes. */

import { Plane, Vector3 } from 'three';
import type { Ray } from 'three';
import type { SurfacePoint, TriangleMesh } from '../../engine/core/core';

export interface Grip {
  point: SurfacePoint;
  place: Vector3;
}

/** Where a ray first meets the surface while its vertices are at `positions`; null where it misses. */
export function gripAt(ray: Ray, { triangles }: TriangleMesh, positions: Float32Array): Grip | null {
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const met = new Vector3();
  let [nearest, least] = [-1, Infinity];
  const place = new Vector3();
  for (let t = 0; t < triangles.length / 3; t++) {
    [a, b, c].forEach((corner, k) => corner.fromArray(positions, 3 * triangles[3 * t + k]));
    if (!ray.intersectTriangle(a, b, c, false, met)) continue;
    const distance = met.distanceToSquared(ray.origin);
    if (distance >= least) continue;
    [nearest, least] = [t, distance];
    place.copy(met);
  }
  if (nearest < 0) return null;
  [a, b, c].forEach((corner, k) => corner.fromArray(positions, 3 * triangles[3 * nearest + k]));
  return { point: { triangle: nearest, barycentric: barycentricOf(place, a, b, c) }, place };
}

function barycentricOf(p: Vector3, a: Vector3, b: Vector3, c: Vector3): [number, number, number] {
  const area = (u: Vector3, v: Vector3, w: Vector3) => v.clone().sub(u).cross(w.clone().sub(u)).length();
  const [ofA, ofB, ofC] = [area(p, b, c), area(p, c, a), area(p, a, b)];
  const total = ofA + ofB + ofC;
  return total > 0 ? [ofA / total, ofB / total, ofC / total] : [1, 0, 0];
}

/** What the tool needs to know and whom it tells. */
export interface DragHost<Name> {
  /** in the pane at `fromX`; null: nothing can be pulled now */
  rayAt(clientX: number, clientY: number, fromX: number): Ray | null;
  gripAt(ray: Ray, clientX: number): { name: Name; grip: Grip } | null;
  grab(name: Name, point: SurfacePoint): void;
  drag(target: [number, number, number]): void;
  release(): void;
}

export class DragTool<Name> {
  private held: { pointer: number; fromX: number; plane: Plane } | null = null;

  /** Listens on the canvas ahead of the camera, which gets every drag that does not begin on a body. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly host: DragHost<Name>,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.begin(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.end(event));
    canvas.addEventListener('pointercancel', (event) => this.end(event));
  }

  private begin(event: PointerEvent): void {
    if (event.button !== 0 || this.held) return;
    const ray = this.host.rayAt(event.clientX, event.clientY, event.clientX);
    const found = ray && this.host.gripAt(ray, event.clientX);
    if (!ray || !found) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.classList.add('dragging');
    // The hand stays as far from the eye as it was.
    const plane = new Plane().setFromNormalAndCoplanarPoint(ray.direction, found.grip.place);
    this.held = { pointer: event.pointerId, fromX: event.clientX, plane };
    this.host.grab(found.name, found.grip.point);
    this.host.drag(found.grip.place.toArray());
  }

  private move({ pointerId, clientX, clientY }: PointerEvent): void {
    if (pointerId !== this.held?.pointer) return;
    const { fromX, plane } = this.held;
    const target = this.host.rayAt(clientX, clientY, fromX)?.intersectPlane(plane, new Vector3());
    if (target) this.host.drag(target.toArray());
  }

  private end(event: PointerEvent): void {
    if (event.pointerId !== this.held?.pointer) return;
    this.held = null;
    this.canvas.classList.remove('dragging');
    this.host.release();
  }
}
