/** Queries on a set of modes. */

import type { ComponentModes, Mode, ModeSet } from './core';
import { counted } from './words';

/** The largest number of elastic modes of a component; ordinals from this number on are empty. */
export function modesAvailable({ components }: Pick<ModeSet, 'components'>): number {
  return components.reduce((most, { modeCount }) => Math.max(most, modeCount), 0);
}

/** Vertices of the largest coarse copy that was solved in place of a part; 0 if every part was solved itself. */
export function coarseVerticesOf({ components }: Pick<ModeSet, 'components'>): number {
  return components.reduce((most, { coarseVertices }) => Math.max(most, coarseVertices), 0);
}

type NamedModes = Pick<ModeSet, 'modes' | 'components'>;

/** The mode that represents an ordinal: that of the part with the most faces, the first of equal ones; null if there is none. */
export function leadingMode({ modes, components }: NamedModes, ordinal: number): Mode | null {
  const own = modes.filter((mode) => mode.ordinal === ordinal);
  const isLarger = (a: Mode, b: Mode) => {
    const difference = components[a.component].faces - components[b.component].faces;
    return difference > 0 || (difference === 0 && a.component < b.component);
  };
  return own.reduce<Mode | null>((lead, mode) => (lead && !isLarger(mode, lead) ? lead : mode), null);
}

/** Those of `modes` (numbers from 1) that are local: little of the body moves. */
export function localModes(set: NamedModes, modes: number[]): number[] {
  return modes.filter((mode) => leadingMode(set, mode - 1)?.name === 'local');
}

/** The first `count` modes (numbers from 1) that are not local, or all of them if there are fewer. */
export function suggestedModes(set: NamedModes, count: number): number[] {
  const all = Array.from({ length: modesAvailable(set) }, (_, ordinal) => ordinal + 1);
  return all.filter((mode) => leadingMode(set, mode - 1)?.name !== 'local').slice(0, count);
}

/** The models of the parts in words: "3 solid parts, 1 shell". A cavity belongs to the solid around it. */
export function describeModels(components: ComponentModes[]): string {
  const cavities = components.filter(({ host }, i) => host !== i).length;
  const own = components.filter(({ host }, i) => host === i);
  const numberOf = (model: ComponentModes['model']) => own.filter((part) => part.model === model).length;
  const kinds: [number, string, string][] = [
    [numberOf('solid'), 'solid part', 'solid parts'],
    [cavities, 'cavity', 'cavities'],
    [numberOf('shell'), 'shell', 'shells'],
    [numberOf('laplacian'), 'Laplacian part', 'Laplacian parts'],
  ];
  return kinds
    .filter(([count]) => count > 0)
    .map(([count, one, many]) => counted(count, one, many))
    .join(', ');
}

/** Mode numbers in words, ascending, with runs of three or more as ranges: "1, 2, 4 to 6". */
export function spellModes(modes: number[]): string {
  const sorted = [...modes].sort((a, b) => a - b);
  const runs: number[][] = [];
  for (const mode of sorted) {
    const run = runs.at(-1);
    if (run && run.at(-1) === mode - 1) run.push(mode);
    else runs.push([mode]);
  }
  return runs.map((run) => (run.length > 2 ? `${run[0]} to ${run.at(-1)}` : run.join(', '))).join(', ');
}
