/** A short run of every fuzz target of the engine. `npm run fuzz` stays longer. */

import { beforeAll, describe, expect, it } from 'vitest';
import { readSettingsFile } from '../../../web/engine/report/settings_reader';
import { fuzzTarget } from './fuzz_target';
import type { FuzzTarget } from './fuzz_target';
import { allTargets } from './main';
import { problemOfRefusal } from './refusal';
import { SETTINGS_FILE } from './settings';

const NAMES = [
  ...['obj', 'ply', 'binary ply', 'stl', 'binary stl', 'off', 'mtl', 'zip', 'gltf', 'glb bytes', 'glb json'],
  ...['compressed glb bytes', 'compressed glb json'],
  ...['options', 'command lines', 'settings files', 'engine files', 'patterns', 'paint'],
  ...['batch configurations', 'patterns of paths', 'links', 'saved state', 'bindings', 'optimize'],
];
let targets: FuzzTarget[];

beforeAll(async () => {
  targets = await allTargets(new URL('../../../public/wasm/', import.meta.url).href);
});

describe('no input breaks a promise', () => {
  it('has a test for every target', () => {
    expect(targets.map(({ name }) => name)).toEqual(NAMES);
  });

  it('reads the settings file that the fuzzer changes', () => {
    expect(readSettingsFile('a.json', JSON.stringify(SETTINGS_FILE)).bodies).toHaveLength(1);
  });

  it.each(NAMES)('%s', async (name) => {
    const target = targets.find((one) => one.name === name)!;
    const { finding, inputs } = await fuzzTarget(target, {
      seed: 1,
      seconds: 60,
      inputs: name === 'optimize' ? 60 : 400,
    });
    expect(finding).toBe('');
    expect(inputs).toBeGreaterThanOrEqual(60);
  });
});

describe('a fuzzer sees', () => {
  const broken = (error: unknown): FuzzTarget => ({
    name: 'broken',
    run: (choices) => {
      if (choices.below(4) === 3) throw error;
    },
  });

  it.each([
    [new TypeError("Cannot read properties of undefined (reading 'x')"), /TypeError/],
    [new Error('undefined is not a mesh.'), /speaks of the program/],
    [new Error('no sentence'), /is no sentence/],
    ['a word', /threw a word/],
  ])('%s', async (error, expected) => {
    expect(problemOfRefusal(error)).toMatch(expected);
    expect((await fuzzTarget(broken(error), { seed: 1, seconds: 10, inputs: 200 })).finding).toMatch(
      expected,
    );
  });

  it('nothing in a refusal', async () => {
    const error = new Error('a.obj has no faces: export it again.');
    expect((await fuzzTarget(broken(error), { seed: 1, seconds: 10, inputs: 200 })).finding).toBe('');
  });
});
