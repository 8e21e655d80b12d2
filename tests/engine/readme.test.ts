import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { format } from 'prettier';
import { expect, it } from 'vitest';
import { OPTIONS } from '../../web/engine/settings/options';
import type { OptionSpec } from '../../web/engine/settings/options';
import type { SolverMaterial, SolverProfile } from '../../web/engine/solvers/profile';
import { profileOf, SOLVER_NAMES } from '../../web/engine/solvers/profiles';

const root = join(import.meta.dirname, '..', '..');

const unitOf = (option: OptionSpec): string => ('unit' in option && option.unit ? ` ${option.unit}` : '');

function range(option: OptionSpec): string {
  if (option.kind === 'choice') return option.choices.join(', ');
  if (option.kind === 'switch') return 'given or not';
  if (option.kind === 'pins' || option.kind === 'colliders') return 'terms joined by +';
  if (option.kind === 'engine') return 'name=value pairs separated by commas';
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

/** A text in a cell of a table. */
const cell = (text: string): string => text.replaceAll('|', '\\|');

/** The flags of the command line. */
function optionsTable(): string {
  const rows = Object.values(OPTIONS).map(
    (option) => `| \`--${option.flag}\` | ${defaultOf(option)} | ${range(option)} | ${cell(option.help)} |`,
  );
  return ['| flag | default | range | meaning |', '| --- | --- | --- | --- |', ...rows].join('\n');
}

/** Values that do not depend on the material and the mesh. */
function constantDefaults(profile: SolverProfile): Record<string, number> {
  const of = (size: number) => {
    const material: SolverMaterial = {
      young: 1e6 * size,
      poisson: 0.1 * size,
      density: 900 * size,
      thickness: 0.01 * size,
      bendRatio: 0.02 * size,
    };
    const facts = {
      area: size,
      vertices: 100 * size,
      faces: 150 * size * size,
      meanEdge: 0.1 * size ** 3,
      unit: 1,
    };
    return profile.defaults(material, facts, {});
  };
  const [some, others] = [of(1), of(2)];
  return Object.fromEntries(Object.entries(some).filter(([name, value]) => others[name] === value));
}

/** Powers of ten from 1e6 on, and below 1e-4, as such. */
function short(value: number): string {
  if (value === 0) return '0';
  const exponent = Math.round(Math.log10(value));
  return value === 10 ** exponent && (exponent < -4 || exponent > 5) ? `1e${exponent}` : `${value}`;
}

/** The parameters of --engine. */
function engineTable(): string {
  const rows = SOLVER_NAMES.flatMap((solver) => {
    const profile = profileOf(solver);
    const defaults = constantDefaults(profile);
    return profile.parameters.map(({ name, alias, unit, min, max, words }) => {
      const names = [name, ...(alias ? [alias] : [])].map((one) => `\`${one}\``).join(', ');
      const own = defaults[name] ?? 'from the material';
      return `| ${solver} | ${names} | ${unit || '-'} | ${short(min)} to ${short(max)} | ${own} | ${cell(words)} |`;
    });
  });
  const head = [
    '| solver | name | unit | range | default | meaning |',
    '| --- | --- | --- | --- | --- | --- |',
  ];
  return [...head, ...rows].join('\n');
}

// LIMBER_UPDATE=1 writes the tables instead of comparing them.
it.each([
  ['README.md', 'options', optionsTable],
  ['docs/formats.md', 'engine', engineTable],
])('%s has the table of %s that agrees with the code', async (file, name, table) => {
  const path = join(root, file);
  const text = readFileSync(path, 'utf8');
  const [start, end] = [`<!-- ${name}:start -->`, `<!-- ${name}:end -->`];
  const made = await format(`${start}\n\n${table()}\n\n${end}\n`, { parser: 'markdown', printWidth: 110 });
  const [before, after] = [text.indexOf(start), text.indexOf(end) + end.length];
  expect(before).toBeGreaterThan(0);
  if (process.env.LIMBER_UPDATE) writeFileSync(path, text.slice(0, before) + made.trim() + text.slice(after));
  else expect(text.slice(before, after)).toBe(made.trim());
});
