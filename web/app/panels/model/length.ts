/** The size of a model in metres, and whether another unit would give a more usual size. */

import { figures } from '../../controls/numbers';

/** Metres. Models outside this range often have a different unit. */
const USUAL = { least: 0.01, most: 20 };

/** Metres per unit, the most usual first. */
const UNITS = [
  { unit: 1, name: 'metres' },
  { unit: 0.01, name: 'centimetres' },
  { unit: 0.001, name: 'millimetres' },
] as const;

type NamedUnit = (typeof UNITS)[number];

/** "176 m", "12.0 cm": a length in metres with three significant digits. */
export function lengthWords(metres: number): string {
  if (metres < 0.01) return `${figures(1000 * metres)}\u00a0mm`;
  if (metres < 1) return `${figures(100 * metres)}\u00a0cm`;
  return `${figures(metres)}\u00a0m`;
}

/** The unit that gives a usual size to a model of `size` units; null if the chosen `unit` does, or no other one does. */
export function likelierUnit(size: number, unit: number): NamedUnit | null {
  const isUsual = (metres: number) => metres >= USUAL.least && metres <= USUAL.most;
  if (isUsual(size * unit)) return null;
  return UNITS.find((other) => isUsual(size * other.unit)) ?? null;
}
