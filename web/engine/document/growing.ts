/** Typed arrays that grow by doubling, for readers that do not know the count in advance. */

/** The initial capacity: small, since a file may have a hundred thousand objects. */
const START = 16;

export class GrowingFloats {
  length = 0;
  private array = new Float32Array(START);

  push3(x: number, y: number, z: number): void {
    if (this.length + 3 > this.array.length) this.grow();
    this.array[this.length++] = x;
    this.array[this.length++] = y;
    this.array[this.length++] = z;
  }

  finish(): Float32Array {
    return this.array.slice(0, this.length);
  }

  at(i: number): number {
    return this.array[i];
  }

  push2(x: number, y: number): void {
    if (this.length + 2 > this.array.length) this.grow();
    this.array[this.length++] = x;
    this.array[this.length++] = y;
  }

  /** The values so far; valid until the next push. */
  view(): Float32Array {
    return this.array.subarray(0, this.length);
  }

  private grow(): void {
    const larger = new Float32Array(2 * this.array.length);
    larger.set(this.array);
    this.array = larger;
  }
}

export class GrowingIndices {
  length = 0;
  private array = new Uint32Array(START);

  push(value: number): void {
    if (this.length === this.array.length) this.grow();
    this.array[this.length++] = value;
  }

  finish(): Uint32Array {
    return this.array.slice(0, this.length);
  }

  at(i: number): number {
    return this.array[i];
  }

  /** The values so far; valid until the next push. */
  view(): Uint32Array {
    return this.array.subarray(0, this.length);
  }

  private grow(): void {
    const larger = new Uint32Array(2 * this.array.length);
    larger.set(this.array);
    this.array = larger;
  }
}
