/** Warnings, one line for all bodies of a model that have the same one. */

import { inModel } from '../engine/report/warnings';
import type { Warning } from '../engine/report/warnings';
import { grouped } from '../engine/core/words';

const NUMBER = /\d+(,\d{3})*(\.\d+)?/g;

/**
 * The lines in the order in which their first warning came. Texts that differ in numbers alone are the same: where a number
 * differs, the line has its span. With `isVerbose`, each warning has a line of its own.
 */
export function warningLines(warnings: Warning[], isVerbose: boolean): string[] {
  const groups = new Map<string, Warning[]>();
  warnings.forEach((warning, i) => {
    const isAlone = isVerbose || typeof warning === 'string';
    const key = isAlone ? `${i}` : inModel(warning, `: ${warning.text.replace(NUMBER, '#')}`);
    const group = groups.get(key);
    if (group) group.push(warning);
    else groups.set(key, [warning]);
  });
  return [...groups.values()].map(lineOf);
}

function lineOf(group: Warning[]): string {
  const bodies = group.filter((warning) => typeof warning !== 'string');
  if (bodies.length === 0) return group[0] as string;
  const [first] = bodies;
  if (bodies.length === 1) return inModel(first, first.alone);
  const text = spanOf(bodies.map((one) => one.text));
  const which = `${grouped(bodies.length)} bodies`;
  // A number is that of one body, and not of all together.
  return inModel(first, text.search(NUMBER) < 0 ? `${which}: ${text}` : `each of ${which}: ${text}`);
}

/** The text with the smallest and largest number at each place where the texts differ. */
function spanOf(texts: string[]): string {
  const numbers = texts.map((text) =>
    (text.match(NUMBER) ?? []).map((word) => Number(word.replaceAll(',', ''))),
  );
  let which = -1;
  return texts[0].replace(NUMBER, (word) => {
    ++which;
    const values = numbers.map((own) => own[which]);
    const [least, most] = values.reduce(
      ([a, b], v) => [Math.min(a, v), Math.max(b, v)],
      [Infinity, -Infinity],
    );
    return least === most ? word : `${least.toLocaleString('en-US')} to ${most.toLocaleString('en-US')}`;
  });
}
