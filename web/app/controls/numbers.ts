/** The formats of numbers on the page. */

import { count } from '../language/say';

export { count };

export const fixed = (value: number, digits: number): string => value.toFixed(digits);

/** Three significant digits without an exponent; larger numbers as integers. */
export const figures = (value: number): string =>
  value < 999.5 ? value.toPrecision(3) : count(Number(value.toPrecision(3)));

/** A short time in the unit that leaves one to three digits before the point: "25.5 µs", "1.91 ms". */
export const shortTime = (seconds: number): string => {
  if (seconds < 999.5e-6) return `${figures(1e6 * seconds)}\u00a0µs`;
  return seconds < 0.9995 ? `${figures(1000 * seconds)}\u00a0ms` : `${figures(seconds)}\u00a0s`;
};

/** Two decimals, or two significant digits if the decimals would be 0; values near the rounding error are given as a bound. */
export const percent = (value: number): string => {
  if (value > 0 && value < 0.001) return '< 0.001 %';
  return value === 0 || value >= 0.1 ? `${value.toFixed(2)} %` : `${Number(value.toPrecision(2))} %`;
};

/** Bytes in kB or MB, without a line break between number and unit. */
export const fileSize = (bytes: number): string =>
  bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1000))}\u00a0kB` : `${(bytes / 1e6).toFixed(1)}\u00a0MB`;
