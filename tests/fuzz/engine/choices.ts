import fc from 'fast-check';

/** Draws choices from a list of numbers, so that fast-check can make failing ones smaller; 0 where the list ends. */
export class Choices {
  private at = 0;
  constructor(private readonly numbers: readonly number[]) {}

  /** in [0, 2^32) */
  bits(): number {
    return this.numbers[this.at++] ?? 0;
  }

  /** a whole number in [0, count) */
  below(count: number): number {
    return this.bits() % count;
  }

  chance(share: number): boolean {
    return this.bits() >= (1 - share) * 2 ** 32;
  }

  pick<T>(list: readonly T[]): T {
    return list[this.below(list.length)];
  }
}

export const numbers = fc.array(fc.nat({ max: 0xffffffff }), { maxLength: 64, size: 'max' });
