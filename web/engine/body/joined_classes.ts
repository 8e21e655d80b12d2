/** Classes of corners that can be joined. */

/** A partition of corners: corners with equal numbers are in one class. */
export interface Classes {
  /** per corner, below `count` */
  wedges: Uint32Array;
  count: number;
}

/** Disjoint sets of classes. The lowest class stands for its set. */
export class JoinedClasses {
  private readonly parent: Uint32Array;

  constructor(count: number) {
    this.parent = Uint32Array.from({ length: count }, (_, i) => i);
  }

  join(a: number, b: number): void {
    const [first, second] = [this.rootOf(a), this.rootOf(b)];
    this.parent[Math.max(first, second)] = Math.min(first, second);
  }

  /** The same corners with one number for each set, ascending with its lowest class. */
  classesOf(wedges: Uint32Array): Classes {
    const numbers = new Uint32Array(this.parent.length);
    let count = 0;
    this.parent.forEach((_, i) => {
      const root = this.rootOf(i);
      numbers[i] = root === i ? count++ : numbers[root];
    });
    return { wedges: wedges.map((wedge) => numbers[wedge]), count };
  }

  private rootOf(i: number): number {
    const { parent } = this;
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  }
}
