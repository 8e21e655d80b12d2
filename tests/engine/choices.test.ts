/** Compares names and limits that the core and the settings both define, as read from the sources of the core. */

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import {
  ATTRIBUTE_LIMIT,
  BORDERS,
  MODE_NAMES,
  MODELS,
  PHASES,
  SIMULATION_MODELS,
  STOP_REASONS,
  VERDICTS,
} from '../../web/engine/core/core';
import { METHOD_NAMES } from '../../web/engine/core/methods';
import { defaultSettings, OPTIONS } from '../../web/engine/settings/options';

const folder = join(import.meta.dirname, '..', '..', 'wasm');
const source = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter((name) => /\.(h|cpp)$/.test(name))
  .sort()
  .map((name) => readFileSync(join(folder, name), 'utf8'))
  .join('\n');

/** The names that the core accepts: every list of strings that is called `list` or ...Names. */
const nameLists = [...source.matchAll(/\b(?:\w*Names|list)\s*=?\s*\{((?:\s*"[^"]*"\s*,?)+)\}/g)].map(
  ([, list]) => [...list.matchAll(/"([^"]*)"/g)].map(([, name]) => name),
);

/** The members of every enum in lower case and in order; their values must count up from 0. */
const enums = new Map(
  [...source.matchAll(/enum class (\w+) : [\w:]+ \{([^}]*)\}/g)].map(([, name, body]) => {
    const members = body
      .replace(/\/\/.*/g, '')
      .split(',')
      .map((member) => /(\w+)(?:\s*=\s*(\d+))?/.exec(member))
      .filter((found) => found !== null);
    members.forEach(([, , value], i) => expect(Number(value ?? i)).toBe(i));
    return [name, members.map(([, member]) => member.toLowerCase())] as const;
  }),
);

const enumLists = [...enums.values()];

/** The value of a constant of the core. */
function constant(name: string): number {
  const found = new RegExp(`\\b${name} = ([\\d.']+)`).exec(source);
  if (!found) throw new Error(`The core has no constant ${name}.`);
  return Number(found[1].replaceAll("'", ''));
}

/** The default of a member of a struct of the core. */
function memberDefault(struct: string, member: string): number {
  const body = new RegExp(`struct ${struct}\\b[^{;]*\\{([\\s\\S]*?)\\n\\};`).exec(source);
  const found = new RegExp(`\\b${member} = ([\\d.]+)`).exec(body?.[1] ?? '');
  if (!found) throw new Error(`${struct} of the core has no default of ${member}.`);
  return Number(found[1]);
}

const sorted = (names: readonly string[]): string[] => [...names].sort();

describe('the core and TypeScript have the same', () => {
  it.each([
    ['elastic models', [...MODELS, 'auto']],
    ['names of modes', MODE_NAMES],
    ['reasons to stop', STOP_REASONS],
  ])('%s, by name and in the order of the enum', (_, names) => {
    expect(nameLists).toContainEqual([...names]);
    expect(enumLists).toContainEqual([...names]);
  });

  it('models of simulation', () => {
    const compared = [...source.matchAll(/\bname == "(\w+)"/g)].map(([, name]) => name);
    expect([...nameLists, compared].map(sorted)).toContainEqual(sorted(SIMULATION_MODELS));
    expect(enumLists).toContainEqual([...SIMULATION_MODELS]);
  });

  it('methods', () => {
    const policies = [...source.matchAll(/\bkName = "(\w+)"/g)].map(([, name]) => name);
    expect(sorted(policies)).toEqual(sorted(METHOD_NAMES));
  });

  it('borders', () => {
    expect(enums.get('Borders')).toEqual([...BORDERS]);
  });

  it('verdicts', () => {
    const verdicts = enums.get('Verdict')!.map((name) => (name === 'locked' ? 'lock' : name));
    expect(verdicts).toEqual([...VERDICTS]);
  });

  it('numbers of phases', () => {
    expect(enums.get('Phase')).toHaveLength(PHASES.length);
  });

  it('scenarios', () => {
    const rows = [...source.matchAll(/^ +\{\.name = "(\w+)"/gm)].map(([, name]) => name);
    expect([...nameLists, rows]).toContainEqual([...OPTIONS.scenario.choices]);
  });

  it('limits', () => {
    expect(constant('kAttributeLimit')).toBe(ATTRIBUTE_LIMIT);
    expect(constant('kMaxSubsteps')).toBe(OPTIONS.substeps.max);
  });

  it('defaults, because the core has none for values that the settings decide', () => {
    const { substeps, friction } = defaultSettings();
    expect([substeps, friction]).not.toContain(0);
    expect(memberDefault('SimulationOptions', 'substeps')).toBe(0);
    expect(memberDefault('SimulationOptions', 'friction')).toBe(0);
  });
});

describe('the settings offer', () => {
  it.each([
    ['method', METHOD_NAMES],
    ['model', [...MODELS, 'auto']],
    ['borders', BORDERS],
    ['material', SIMULATION_MODELS],
  ] as const)('for %s exactly the names that the core accepts', (setting, names) => {
    expect(sorted(OPTIONS[setting].choices)).toEqual(sorted(names));
  });
});
