import { execFileSync } from 'node:child_process';
import { expect, test } from 'vitest';
import { commandLine } from '../../web/app/command_line';
import { parseArguments } from '../../web/cli/arguments';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';

const files = { faces: 120, fields: false, binding: null, settings: null, isMissed: false };

/** The words that a shell makes of a line. */
const wordsOf = (line: string): string[] =>
  execFileSync('sh', ['-c', `printf '%s\\0' ${line}`])
    .toString()
    .split('\0')
    .slice(0, -1);

const parsed = (line: string) => {
  const [program, ...words] = wordsOf(line);
  expect(program).toBe('limber');
  const found = parseArguments(words);
  if ('show' in found) throw new Error('The line asks a question.');
  return found;
};

const CHANGES: Partial<Settings>[] = [
  {},
  { method: 'paper' },
  { method: 'qem', minAngle: 4, maxDeviation: 0 },
  { modes: [1, 3], modeWeights: [1, 0.5], symmetry: 'on', borders: 'fixed', seams: 'cross' },
  { pins: 'low:6+vertices:1,2', maxFrequencyError: 5, lods: [0.5, 0.25] },
  { solver: 'jolt', tune: 'vertex', young: 2e5, thickness: 0.01 },
];

test.each(CHANGES)('the command line says all settings, and the program reads them back: %j', (change) => {
  const settings = { ...defaultSettings(change.method), ...change };
  const line = commandLine(settings, 'a chair.glb', 'a chair-limber.glb', files);
  const found = parsed(line);
  expect(found.settings).toEqual(settings);
  expect(found.operands).toEqual(['a chair.glb', 'a chair-limber.glb']);
  expect(found.faces).toBe(120);
  expect(found.soft).toBe(false);
});

test('what the method does not read is left out', () => {
  const settings: Settings = { ...defaultSettings('qem'), fit: 'modal', strainWeight: 3 };
  const line = commandLine(settings, 'a.glb', 'b.glb', files);
  expect(line).not.toMatch(/--(fit|strain)/);
  expect(parsed(line).settings.method).toBe('qem');
});

test('names of files stay names, whatever is in them', () => {
  for (const name of ['-rf.glb', "it's $(odd) `here`.glb", 'ü "x" \\.glb']) {
    const [input] = parsed(commandLine(defaultSettings(), name, 'out.glb', files)).operands;
    expect(input.replace(/^\.\//, '')).toBe(name);
  }
});

test('further files are requested, and a result above the target is no failure', () => {
  const asked = { ...files, binding: 'b.json', settings: 's.json', fields: true, isMissed: true };
  const found = parsed(commandLine({ ...defaultSettings(), solver: 'shell' }, 'a.glb', 'b.glb', asked));
  expect(found).toMatchObject({ bind: 'b.json', settingsFile: 's.json', fields: true, soft: true });
});

test('an empty name, as from an unset variable, is refused with the argument that it is for', () => {
  const refused = (...words: string[]) =>
    expect(() => parseArguments(words)).toThrow(/^(\S+) is empty: give the name of a file: limber /);
  refused('optimize', '', 'out.glb');
  refused('optimize', 'in.glb', '');
  refused('batch', 'a', 'b', '');
});
