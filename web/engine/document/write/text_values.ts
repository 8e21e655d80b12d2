/** Numbers as text, colours in sRGB, and the removal of duplicate lines. */

/** The shortest decimal that reads back as the same 32-bit number. */
export function shortest(value: number): string {
  const wanted = Math.fround(value);
  for (let digits = 6; digits < 9; ++digits) {
    const text = wanted.toPrecision(digits);
    if (Math.fround(Number(text)) === wanted) return String(Number(text));
  }
  return String(Number(wanted.toPrecision(9)));
}

/** Linear light to sRGB (IEC 61966-2-1). */
export function toSrgb(linear: number): number {
  const value = Math.min(1, Math.max(0, linear));
  return value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
}

/** The distinct texts in the order of their first use, and per text its number among them. */
export function distinctTexts(texts: string[]): { values: string[]; indices: Uint32Array } {
  const numbers = new Map<string, number>();
  const indices = Uint32Array.from(texts, (text) => {
    const known = numbers.get(text);
    if (known !== undefined) return known;
    numbers.set(text, numbers.size);
    return numbers.size - 1;
  });
  return { values: [...numbers.keys()], indices };
}
