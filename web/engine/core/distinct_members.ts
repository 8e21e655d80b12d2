/** Distinct members of groups, found by value, such as the distinct corners at each vertex. */

import { NONE } from './core';

/** Longer groups are searched by hashes; they are rare, as at vertices in which very many faces meet. */
const LONG = 32;

/** The last member of each group; undefined or NONE where it has none. */
export interface LastMembers {
  get(group: number): number | undefined;
  set(group: number, member: number): unknown;
}

export class DistinctMembers {
  private readonly previous: number[] = [];
  /** the members of long groups by their hashes */
  private readonly hashed = new Map<number, Map<number, number[]>>();

  /** `hashOf`: equal for members that are alike. */
  constructor(
    private readonly hashOf: (member: number) => number,
    private readonly last: LastMembers = new Map<number, number>(),
  ) {}

  /** The member of a group for which `isSame` is true; NONE without one. `hash`: that of the wanted value. */
  find(group: number, isSame: (member: number) => boolean, hash: () => number): number {
    const byHash = this.hashed.get(group);
    if (byHash) return byHash.get(hash())?.find(isSame) ?? NONE;
    let [found, steps] = [this.last.get(group) ?? NONE, 0];
    for (; found !== NONE && !isSame(found); ++steps) found = this.previous[found];
    if (steps > LONG) this.hashAll(group);
    return found;
  }

  /** Adds a member and returns its number, counted from 0; `hashOf` must know it already. */
  add(group: number): number {
    const member = this.previous.length;
    this.previous.push(this.last.get(group) ?? NONE);
    this.last.set(group, member);
    const byHash = this.hashed.get(group);
    if (byHash) this.enter(byHash, member);
    return member;
  }

  private hashAll(group: number): void {
    const byHash = new Map<number, number[]>();
    for (let one = this.last.get(group) ?? NONE; one !== NONE; one = this.previous[one])
      this.enter(byHash, one);
    this.hashed.set(group, byHash);
  }

  private enter(byHash: Map<number, number[]>, member: number): void {
    const hash = this.hashOf(member);
    const known = byHash.get(hash);
    if (known) known.push(member);
    else byHash.set(hash, [member]);
  }
}

const number = new Float64Array(1);
const words = new Uint32Array(number.buffer);

/** Extends a hash by one more number; 0 and -0 give the same hash. */
export function extendHash(hash: number, value: number): number {
  number[0] = value + 0;
  const low = Math.imul(hash ^ words[0], 0x85ebca6b);
  const high = Math.imul(low ^ (low >>> 15) ^ words[1], 0xc2b2ae35);
  return high ^ (high >>> 13);
}
