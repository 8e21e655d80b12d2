import fc from 'fast-check';

/** Scatters numbers, of which fast-check draws mostly small and large ones, over the whole range; 0 stays 0 (MurmurHash3). */
function scattered(number: number): number {
  let bits = Math.imul(number ^ (number >>> 16), 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 13), 0xc2b2ae35);
  return (bits ^ (bits >>> 16)) >>> 0;
}

/** Draws choices from a list of numbers, so that fast-check can make failing ones smaller; 0 where the list ends. */
export class Choices {
  private at = 0;
  constructor(private readonly numbers: readonly number[]) {}

  /** in [0, 2^32) */
  bits(): number {
    return scattered(this.numbers[this.at++] ?? 0);
  }

  /** a whole number in [0, count) */
  below(count: number): number {
    return this.bits() % count;
  }

  chance(share: number): boolean {
    return this.bits() < share * 2 ** 32;
  }

  pick<T>(list: readonly T[]): T {
    return list[this.below(list.length)];
  }
}

export const numbers = fc.array(fc.nat({ max: 0xffffffff }), { maxLength: 64, size: 'max' });
