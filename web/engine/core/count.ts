/** Whether a value from a file can be a number of things, or the index of one. */
export const isCount = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;
