/** Distributes faces among the bodies of a scene by one queue of their errors. */

import type { Refused } from '../../core/core';
import { sumRefused } from '../../report/stop_report';
import type { ErrorCurve } from './error_curve';

/** One body of a scene. */
export interface SceneBody {
  curve: ErrorCurve;
  /** units of the scene per unit of the body, with all instances: see instanceScale */
  scale: number;
  /** deviation limit in % of the body's diagonal, beyond which other bodies go first; 0: none */
  limit: number;
}

/** The entry of a body in the queue: the next step on its error curve. */
interface Waiting {
  body: number;
  entry: number;
  /** whether that entry goes beyond the limit of the body */
  isBeyond: boolean;
  /** of that entry, in units of the scene */
  error: number;
  /** of the steps on the curve, up to that entry */
  share: number;
}

/**
 * The order in which all bodies lose their faces, smallest error first. Steps beyond the limit of their body come
 * after all others; then the smaller error in units of the scene comes first; of equal ones, that of the body which has taken the smaller
 * share of its steps, so that equal bodies stay equal up to a step; then the lower index. So at any count the largest error of the scene is
 * the smallest that is possible with these curves.
 */
export class SceneQueue {
  /** bodies[i]: the body that takes the i-th step; left[i]: the faces of the scene, as written, after it */
  private readonly bodies: Uint32Array;
  private readonly left: Float64Array;
  private readonly total: number;

  constructor(private readonly scene: readonly SceneBody[]) {
    const steps = scene.reduce((count, { curve }) => count + curve.ends.length - 1, 0);
    this.bodies = new Uint32Array(steps);
    this.left = new Float64Array(steps);
    this.total = scene.reduce((count, { curve }) => count + curve.written[0], 0);
    this.merge();
  }

  /** The written faces of the original scene. */
  get faces(): number {
    return this.total;
  }

  /** The fewest written faces that the scene can have. */
  get fewest(): number {
    return this.left.length > 0 ? this.left[this.left.length - 1] : this.total;
  }

  /** Why it cannot have fewer: the counts of all bodies together. */
  get refused(): Refused {
    return sumRefused(this.scene.map(({ curve }) => curve.refused));
  }

  /**
   * Per body the faces of its level where the scene has at most `target` written faces, as many as the order reaches; the floors
   * where it cannot have so few.
   */
  targets(target: number): number[] {
    const taken = new Uint32Array(this.scene.length);
    for (let i = 0, left = this.total; left > target && i < this.left.length; ++i) {
      taken[this.bodies[i]] += 1;
      left = this.left[i];
    }
    return this.scene.map(({ curve }, body) => curve.faces[taken[body]]);
  }

  private merge(): void {
    const heap = new Heap();
    const push = (body: number, entry: number): void => {
      const { curve, scale, limit } = this.scene[body];
      if (entry >= curve.ends.length) return;
      const error = curve.errors[entry];
      const isBeyond = limit > 0 && error > (limit / 100) * curve.diagonal;
      heap.push({ body, entry, isBeyond, error: scale * error, share: entry / (curve.ends.length - 1) });
    };
    this.scene.forEach((_, body) => push(body, 1));
    let left = this.total;
    for (let i = 0; i < this.bodies.length; ++i) {
      const { body, entry } = heap.pop();
      const { written } = this.scene[body].curve;
      left -= written[entry - 1] - written[entry];
      this.bodies[i] = body;
      this.left[i] = left;
      push(body, entry + 1);
    }
  }
}

const comesFirst = (a: Waiting, b: Waiting): boolean => {
  if (a.isBeyond !== b.isBeyond) return b.isBeyond;
  if (a.error !== b.error) return a.error < b.error;
  return a.share !== b.share ? a.share < b.share : a.body < b.body;
};

/** A binary heap with the first one on top. */
class Heap {
  private readonly items: Waiting[] = [];

  push(item: Waiting): void {
    let slot = this.items.push(item) - 1;
    while (slot > 0) {
      const parent = (slot - 1) >> 1;
      if (!comesFirst(item, this.items[parent])) break;
      this.items[slot] = this.items[parent];
      slot = parent;
    }
    this.items[slot] = item;
  }

  /** Removes the first entry; the heap must not be empty. */
  pop(): Waiting {
    const first = this.items[0];
    const last = this.items.pop()!;
    if (this.items.length > 0) this.moveDown(last);
    return first;
  }

  private moveDown(item: Waiting): void {
    let slot = 0;
    for (;;) {
      let child = 2 * slot + 1;
      if (child >= this.items.length) break;
      if (child + 1 < this.items.length && comesFirst(this.items[child + 1], this.items[child])) child += 1;
      if (!comesFirst(this.items[child], item)) break;
      this.items[slot] = this.items[child];
      slot = child;
    }
    this.items[slot] = item;
  }
}
