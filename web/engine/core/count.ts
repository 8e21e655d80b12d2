/** Whether a value from a file is a non-negative safe integer, as counts and indices are. */
export const isCount = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;
