/** The progress of a call that works on the bodies of a file, as a share of its work that never decreases. */

/** Shares of the work of a call, 0..1. */
export interface WorkSpan {
  /** the share that is done */
  done: number;
  /** the share that will be done when the running call of the core ends, if its progress counts; otherwise `done` */
  next: number;
}

/** Runs a piece of work; `isOneCall`: it is a single call of the core, whose progress runs from 0 to 1 once. */
export type Piece = (work: number, make: () => void, isOneCall?: boolean) => void;

/** Shares that differ by less are equal. */
const ROUNDING = 1e-9;

export class FileProgress {
  private done = 0;

  /** `tell` is called before each piece of work, and with null after the last one that counts. */
  constructor(private readonly tell: (span: WorkSpan | null) => void = () => {}) {}

  /** Starts again at 0 for another call. */
  restart(): void {
    this.done = 0;
  }

  /**
   * Begins a pass over bodies, which takes `share` of the rest of the call. `all`: the work of all of its pieces, in the unit of
   * each; pieces without work are not reported.
   */
  pass(all: number, share: number): Piece {
    const scale = all > 0 ? (share * (1 - this.done)) / all : 0;
    return (work, make, isOneCall = false) => {
      const next = Math.min(1, this.done + scale * work);
      if (work > 0) this.tell({ done: this.done, next: isOneCall ? next : this.done });
      make();
      this.done = next;
      if (work > 0 && next > 1 - ROUNDING) this.tell(null);
    };
  }
}
