/** The tool that drags a moving body: finds the point where a ray hits the body, and moves it with the pointer. */

import { Plane, Vector3 } from 'three';
import type { Ray } from 'three';
import type { SurfacePoint, TriangleMesh } from '../../engine/core/core';

export interface SurfaceHit {
  point: SurfacePoint;
  position: Vector3;
}

/** The first hit of a ray on the surface with its vertices at `positions`; null if it misses. O(triangles). */
export function hitAt(ray: Ray, { triangles }: TriangleMesh, positions: Float32Array): SurfaceHit | null {
  const corners: Corners = [new Vector3(), new Vector3(), new Vector3()];
  const load = (t: number) =>
    corners.forEach((corner, k) => corner.fromArray(positions, 3 * triangles[3 * t + k]));
  let [nearest, least] = [-1, Infinity];
  const [candidate, position] = [new Vector3(), new Vector3()];
  for (let t = 0; t < triangles.length / 3; t++) {
    load(t);
    if (!ray.intersectTriangle(...corners, false, candidate)) continue;
    const distance = candidate.distanceToSquared(ray.origin);
    if (distance >= least) continue;
    [nearest, least] = [t, distance];
    position.copy(candidate);
  }
  if (nearest < 0) return null;
  load(nearest);
  return { point: { triangle: nearest, barycentric: barycentricOf(position, corners) }, position };
}

type Corners = [Vector3, Vector3, Vector3];

function barycentricOf(p: Vector3, [a, b, c]: Corners): [number, number, number] {
  const area = (u: Vector3, v: Vector3, w: Vector3) => v.clone().sub(u).cross(w.clone().sub(u)).length();
  const [ofA, ofB, ofC] = [area(p, b, c), area(p, c, a), area(p, a, b)];
  const total = ofA + ofB + ofC;
  return total > 0 ? [ofA / total, ofB / total, ofC / total] : [1, 0, 0];
}

/** What the tool needs of the page, and what it reports. */
export interface DragHost<Name> {
  /** the ray through a point of the page, in the pane at `fromX`; null if nothing can be dragged now */
  rayAt(clientX: number, clientY: number, fromX: number): Ray | null;
  /** the body that the ray hits in the pane at `clientX` */
  hitAt(ray: Ray, clientX: number): { name: Name; hit: SurfaceHit } | null;
  grab(name: Name, point: SurfacePoint): void;
  drag(target: [number, number, number]): void;
  release(): void;
}

export class DragTool<Name> {
  private grip: { pointer: number; fromX: number; plane: Plane } | null = null;

  /** Listens on the canvas before the camera, which gets every drag that does not begin on a body. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly host: DragHost<Name>,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.onPress(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.onMove(event));
    canvas.addEventListener('pointerup', (event) => this.onRelease(event));
    canvas.addEventListener('pointercancel', (event) => this.onRelease(event));
  }

  private onPress(event: PointerEvent): void {
    if (event.button !== 0 || this.grip) return;
    const ray = this.host.rayAt(event.clientX, event.clientY, event.clientX);
    const found = ray && this.host.hitAt(ray, event.clientX);
    if (!ray || !found) return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.classList.add('dragging');
    // The point moves in the plane through it that faces the camera.
    const plane = new Plane().setFromNormalAndCoplanarPoint(ray.direction, found.hit.position);
    this.grip = { pointer: event.pointerId, fromX: event.clientX, plane };
    this.host.grab(found.name, found.hit.point);
    this.host.drag(found.hit.position.toArray());
  }

  private onMove({ pointerId, clientX, clientY }: PointerEvent): void {
    if (pointerId !== this.grip?.pointer) return;
    const { fromX, plane } = this.grip;
    const target = this.host.rayAt(clientX, clientY, fromX)?.intersectPlane(plane, new Vector3());
    if (target) this.host.drag(target.toArray());
  }

  private onRelease(event: PointerEvent): void {
    if (event.pointerId !== this.grip?.pointer) return;
    this.grip = null;
    this.canvas.classList.remove('dragging');
    this.host.release();
  }
}
