import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { format } from 'prettier';
import { expect, test } from 'vitest';
import { OPTIONS } from '../../web/engine/settings/options';
import type { OptionSpec } from '../../web/engine/settings/options';

const readme = join(import.meta.dirname, '..', '..', 'README.md');
const [start, end] = ['<!-- options:start -->', '<!-- options:end -->'];

const unitOf = (option: OptionSpec): string => ('unit' in option && option.unit ? ` ${option.unit}` : '');

function range(option: OptionSpec): string {
  if (option.kind === 'choice') return option.choices.join(', ');
  if (option.kind === 'switch') return 'given or not';
  if (option.kind === 'pins' || option.kind === 'colliders') return 'terms joined by +';
  if (option.kind === 'engine') return 'name=value with commas';
  if (option.kind === 'name') return 'name of an attribute';
  if (option.kind === 'pattern') return 'names with * and ?';
  if (option.kind === 'paint') return 'as the page writes it';
  if (option.kind === 'modes') return 'auto, all, 1,2,...';
  return `${option.min} to ${option.max === Infinity ? 'inf' : option.max}${unitOf(option)}`;
}

function defaultOf(option: OptionSpec): string {
  const value = option.default;
  if (Array.isArray(value)) return value.length ? value.join(',') : '(none)';
  if (value === '') return '(none)';
  return `${value}${value !== 0 ? unitOf(option) : ''}`;
}

/** The table of flags in the form of the README. */
async function optionsTable(): Promise<string> {
  const rows = Object.values(OPTIONS).map(
    (option) => `| \`--${option.flag}\` | ${defaultOf(option)} | ${range(option)} | ${option.help} |`,
  );
  const table = ['| flag | default | range | meaning |', '| --- | --- | --- | --- |', ...rows].join('\n');
  return format(`${start}\n\n${table}\n\n${end}\n`, { parser: 'markdown', printWidth: 110 });
}

// LIMBER_UPDATE=1 writes the table instead of comparing it.
test("the README's table of flags agrees with the settings", async () => {
  const text = readFileSync(readme, 'utf8');
  const table = (await optionsTable()).trim();
  const [before, after] = [text.indexOf(start), text.indexOf(end) + end.length];
  if (process.env.LIMBER_UPDATE) writeFileSync(readme, text.slice(0, before) + table + text.slice(after));
  else expect(text.slice(before, after)).toBe(table);
});
