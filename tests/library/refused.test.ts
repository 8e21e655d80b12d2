/** What calls of the library refuse, each in one sentence with the type of what was given. */

import { expect, it } from 'vitest';
import { inspect, optimize, tune } from '../../web/library/calls';
import { LimberError } from '../../web/library/options';
import type { RunOptions, TuneOptions } from '../../web/library/options';
import type { CommandName, Failure, WorkMessage } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { textFile } from '../engine/support/files';
import { toObj, torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;
const RING = [textFile('ring.obj', toObj(torus()))];
const BYTES = RING[0].bytes;

async function refused(command: CommandName, options: object): Promise<Failure> {
  const messages: WorkMessage[] = [];
  const server = new Server((message) => messages.push(message));
  await server.answer({ command, models: [RING, RING], options, core: { wasmFolder } });
  return (messages.at(-1) as { failure: Failure }).failure;
}

it.each<[CommandName, object, string, string | null]>([
  [
    'optimize',
    { method: 'foo' },
    'method is "foo": give one of limber, paper, qem (default: limber).',
    'method',
  ],
  ['optimize', { method: 1 }, 'method is 1: give one of limber, paper, qem (default: limber).', 'method'],
  [
    'optimize',
    { method: ['qem'] },
    'method is ["qem"]: give one of limber, paper, qem (default: limber).',
    'method',
  ],
  ['optimize', { young: '5' }, 'young is "5": give a number from ', 'young'],
  ['optimize', { p: 'inf' }, 'p is "inf": give a number of at least 1, or Infinity (default: 2).', 'p'],
  [
    'optimize',
    { calibrate: 'true' },
    'calibrate is "true": give true or false (default: false).',
    'calibrate',
  ],
  [
    'optimize',
    { lods: 0.5 },
    'lods is 0.5: give a list of numbers from 0.0001 to 1 (default: none).',
    'lods',
  ],
  [
    'optimize',
    { lods: ['0.5'] },
    'lods is ["0.5"]: give a list of numbers from 0.0001 to 1 (default: none).',
    'lods',
  ],
  [
    'optimize',
    { modes: '1,2' },
    'modes is "1,2": give "auto", "all", or a list of different whole numbers from 1 to 100 (default: auto).',
    'modes',
  ],
  ['optimize', { pins: [1] }, 'pins is [1]: give terms joined by +, as a string (default: none).', 'pins'],
  [
    'optimize',
    { engine: { a: 1 } },
    'engine is an object: give name=value pairs separated by commas, as a string (default: none).',
    'engine',
  ],
  ['optimize', { faces: '100' }, 'faces is "100": give a whole number of at least 1.', null],
  ['optimize', { ratio: '0.5' }, 'ratio is "0.5": give a number above 0 and up to 1.', null],
  ['optimize', { ratio: null }, 'ratio is null: give a number above 0 and up to 1.', null],
  ['optimize', { bind: 'yes' }, 'bind is "yes": give true or false.', null],
  ['optimize', { fields: 1 }, 'fields is 1: give true or false.', null],
  ['optimize', { validate: null }, 'validate is null: give true or false.', null],
  ['modes', { writesShapes: 'a.glb' }, 'writesShapes is "a.glb": give true or false.', null],
  ['simulate', { binding: {} }, 'binding is an object: give the text of a binding file, or null.', null],
  [
    'simulate',
    { binding: '{}' },
    'binding is no binding file, because its "schema" is not "limber-binding/1": give the binding that optimize returns with bind: true.',
    null,
  ],
  [
    'simulate',
    { settingsFile: '{' },
    'settingsFile is not JSON: give the settingsFile that tune, or optimize with a solver, returns.',
    null,
  ],
  [
    'optimize',
    { rato: 0.5 },
    'optimize does not take "rato", which is no option: did you mean "ratio"?',
    null,
  ],
  [
    'optimize',
    { 'max-deviation': 1 },
    'optimize does not take "max-deviation", which is no option: did you mean "maxDeviation"?',
    null,
  ],
  [
    'inspect',
    { wantsBody: true },
    'inspect does not take "wantsBody", which is no option: see the README of the package.',
    null,
  ],
  [
    'optimize',
    { method: 'paper', fit: 'modal' },
    'fit is "modal", but paper does not use it: leave it out, or give method limber.',
    'fit',
  ],
  [
    'optimize',
    { method: 'qem', qualityWeight: 2 },
    'qualityWeight is 2, but qem does not use it: leave it out, or give method limber or paper.',
    'qualityWeight',
  ],
  ['optimize', { engine: 'young=1' }, 'engine needs a solver: name one of shell, ', 'engine'],
  ['simulate', { massRule: 'vertex' }, 'massRule needs a solver: name one of shell, ', 'massRule'],
  [
    'simulate',
    { solver: 'jolt', settingsFile: '{}', massRule: 'area' },
    'massRule is given together with a settings file, which already has the parameters of the original: leave one of them out.',
    'massRule',
  ],
  [
    'tune',
    { solver: 'mujoco', bendRatio: 0.1 },
    'bendRatio is for springs and dihedral if no bend constant is given in engine: leave it out, and give mujoco its own numbers by engine.',
    'bendRatio',
  ],
  ['tune', {}, 'tune needs a solver: name one of shell, ', null],
  [
    'optimize',
    { wantsBodies: true, format: 'obj' },
    'format is "obj", but a document is no file: leave it out, ',
    'format',
  ],
  [
    'optimize',
    { wantsBodies: true, compress: 'draco' },
    'compress is "draco", but a document is not compressed: leave it out, ',
    'compress',
  ],
  [
    'optimize',
    { wantsBodies: true, lods: [0.3], lodStyle: 'msft' },
    'lodStyle is "msft", but levels of a document are files: leave it out, ',
    'lodStyle',
  ],
])('%s refuses %j', async (command, options, sentence, setting) => {
  const failure = await refused(command, { threads: 1, ...options });
  expect(failure.message.slice(0, sentence.length)).toBe(sentence);
  expect(failure).toMatchObject({ setting, isInternal: false });
});

it.each([
  [null, 'run is null: give an object with signal, onProgress, assets, or leave it out.'],
  [{ signal: 5 }, 'run.signal is 5: give the signal of an AbortController.'],
  [{ signal: new AbortController() }, 'run.signal is an object: give the signal of an AbortController.'],
  [{ onProgress: 5 }, 'run.onProgress is 5: give a function.'],
  [{ progress: 5 }, 'run has "progress", which is not known: it takes signal, onProgress, assets.'],
])('a run that is %j is refused before the worker', async (run, sentence) => {
  await expect(inspect(BYTES, {}, run as RunOptions)).rejects.toThrow(new LimberError(sentence));
});

it.each([null, 'ratio', [1]])('options that are %j are refused before the worker', async (options) => {
  const call = optimize(BYTES, options as object);
  await expect(call).rejects.toThrow(LimberError);
  await expect(call).rejects.toThrow(
    `The options are ${JSON.stringify(options)}: give an object such as { solver: "jolt" }, or leave them out.`,
  );
  await expect(tune(BYTES, BYTES, options as unknown as TuneOptions)).rejects.toThrow(LimberError);
});

it.each(['signal', 'onProgress', 'assets'])('%s among the options is told to be of the run', async (name) => {
  const options = { ratio: 0.5, [name]: () => {} };
  for (const call of [optimize(BYTES, options), inspect(BYTES, { [name]: undefined } as object)])
    await expect(call).rejects.toThrow(
      new LimberError(
        `The options have "${name}", which is of the run: give { ${name} } as an argument of its own after them.`,
      ),
    );
});
