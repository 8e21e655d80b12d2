/** Numbers as the page writes them. */

export { count } from '../language/say';

export const fixed = (value: number, digits: number): string => value.toFixed(digits);

/** Two decimals, or two figures where these would all be 0; values near rounding are given as a bound. */
export const percent = (value: number): string => {
  if (value > 0 && value < 0.001) return '< 0.001 %';
  return value === 0 || value >= 0.1 ? `${value.toFixed(2)} %` : `${Number(value.toPrecision(2))} %`;
};

/** Bytes in kB or MB, which no line break parts from their number. */
export const fileSize = (bytes: number): string =>
  bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1000))}\u00a0kB` : `${(bytes / 1e6).toFixed(1)}\u00a0MB`;
