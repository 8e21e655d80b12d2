// The schemas against real reports of every command. The validator of JSON Schema is installed into an empty folder.

import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { readBatchConfig, writeBatchConfig } from '../../web/engine/settings/batch_config';
import { defaultSettings } from '../../web/engine/settings/options';
import { cube, grid, toObj, torus } from '../engine/support/shapes';
import { install, makeFolder, node, root } from './support';

const VALIDATOR = 'ajv@8.20.0';
const program = join(root, 'dist', 'cli', 'limber.mjs');
const read = (path: string) => JSON.parse(readFileSync(path, 'utf8'));
const schemaOf = (name: string) => read(join(root, 'docs', `${name}.schema.json`));

interface Schema {
  properties?: Record<string, Schema>;
  additionalProperties?: unknown;
  [key: string]: unknown;
}

/** The schema without the freedom to add keys: what is written now has to be described. */
function closed(schema: unknown): unknown {
  if (Array.isArray(schema)) return schema.map(closed);
  if (typeof schema !== 'object' || schema === null) return schema;
  const own = Object.fromEntries(
    Object.entries(schema).map(([key, value]) => [key, closed(value)]),
  ) as Schema;
  const isClosed = own.properties && typeof own.type === 'string' && own.additionalProperties === undefined;
  return isClosed ? { ...own, additionalProperties: false } : own;
}

let folder: string;
type Validate = ((value: unknown) => boolean) & { errors?: unknown };
let validate: Record<'report' | 'settings' | 'batch', Validate>;

const limber = (...args: string[]) => node(folder, program, ...args, '--quiet');

/** Each with the files that it writes. */
const COMMANDS: Record<string, string[]> = {
  inspect: ['inspect', 'ring.obj'],
  modes: ['modes', 'box.obj'],
  'modes of the laplacian': ['modes', 'ring.obj', '--model', 'laplacian'],
  optimize: ['optimize', 'ring.obj', 'ring.glb', '--lods', '0.3,0.2', '--soft'],
  'optimize with all targets': [
    ...['optimize', 'sheet.obj', 'a.glb', '--max-frequency-error', '5', '--max-deviation', '2'],
    ...['--min-angle', '10', '--fit', 'modal', '--calibrate'],
  ],
  'optimize by the paper': ['optimize', 'ring.obj', 'b.glb', '--method', 'paper'],
  'optimize without a guide': ['optimize', 'sheet.obj', 'c.glb', '--method', 'qem', '--p', 'inf'],
  'optimize for a solver': ['optimize', 'sheet.obj', 'd.glb', '--solver', 'jolt', '--settings', 'jolt.json'],
  'optimize without frequencies in the solver': ['optimize', 'sheet.obj', 'f.glb', '--solver', 'springs'],
  'optimize for steps that blow up': [
    ...['optimize', 'sheet.obj', 'e.glb', '--solver', 'blender', '--engine', 'bending_damping=900'],
  ],
  tune: [
    ...['tune', 'ring.obj', 'ring.glb', '--solver', 'springs'],
    ...['--tune', 'constraint', '--settings', 'springs.json'],
  ],
  'tune a map': [
    'tune',
    'sheet.obj',
    'c.glb',
    '--solver',
    'hinge-shell',
    '--tune',
    'vertex',
    '--settings',
    'map.json',
  ],
  compare: ['compare', 'ring.obj', 'ring.glb'],
  simulate: ['simulate', 'sheet.obj', 'c.glb', '--seconds', '0.1', '--calibrate'],
  'simulate one': ['simulate', 'sheet.obj', '--seconds', '0.1', '--scenario', 'hang'],
  'simulate in a solver': ['simulate', 'sheet.obj', 'd.glb', '--settings', 'jolt.json', '--seconds', '0.1'],
};

beforeAll(async () => {
  if (!existsSync(program)) throw new Error('dist/cli/limber.mjs is missing: run npm run build first.');
  folder = makeFolder('schemas');
  install(folder, VALIDATOR);
  const { Ajv2020 } = await import(join(folder, 'node_modules', 'ajv', 'dist', '2020.js'));
  const ajv = new Ajv2020({ allErrors: true, allowUnionTypes: true });
  const compile = (name: string) => ajv.compile(closed({ ...schemaOf(name), $id: undefined })) as Validate;
  validate = { report: compile('report'), settings: compile('settings'), batch: compile('batch') };
  for (const [name, mesh] of Object.entries({ ring: torus(), box: cube(), sheet: grid(12, 12) }))
    writeFileSync(join(folder, `${name}.obj`), toObj(mesh));
}, 120_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

function expectValid(kind: keyof typeof validate, value: unknown): void {
  expect([validate[kind](value), validate[kind].errors]).toEqual([true, null]);
}

describe('the schema of reports', () => {
  it.each(Object.keys(COMMANDS))('takes the report of %s', (name) => {
    const report = JSON.parse(limber(...COMMANDS[name], '--report', '-'));
    expectValid('report', report);
  });

  it('refuses what is no report', () => {
    const report = JSON.parse(limber('inspect', 'ring.obj', '--report', '-'));
    for (const wrong of [
      { ...report, schema: 'limber-report/9' },
      { ...report, threads: 0 },
      { ...report, input: { ...report.input, faces: -1 } },
      { ...report, input: { ...report.input, holes: 1 } },
      { ...report, timings: undefined },
    ])
      expect(validate.report(wrong)).toBe(false);
  });
});

describe('the schema of settings files', () => {
  it.each(['jolt', 'springs', 'map'])('takes %s.json', (name) => {
    expectValid('settings', read(join(folder, `${name}.json`)));
  });

  it('refuses what is no settings file', () => {
    const settings = read(join(folder, 'jolt.json'));
    for (const wrong of [
      { ...settings, schema: 'limber-settings/0' },
      { ...settings, bodies: [] },
      { ...settings, units: { length: -1 } },
    ])
      expect(validate.settings(wrong)).toBe(false);
  });
});

describe('the schema of batch configurations', () => {
  const example = () =>
    JSON.parse(/```json\n([^]*?)```/.exec(readFileSync(join(root, 'docs', 'batch.md'), 'utf8'))![1]);

  it('takes the example, which limber takes too, and what is written of settings', () => {
    expectValid('batch', example());
    expect(readBatchConfig(JSON.stringify(example()), 'example').overrides).toHaveLength(2);
    const settings = { ...defaultSettings('paper'), p: Infinity, lods: [0.5] };
    expectValid('batch', JSON.parse(writeBatchConfig(settings, { ratio: 0.5 })));
  });

  it('refuses what limber refuses', () => {
    for (const wrong of [
      { ...example(), schema: 'limber-batch/2' },
      { ...example(), option: {} },
      { ...example(), options: { ratio: 2 } },
      { ...example(), overrides: [{ files: [], options: {} }] },
    ]) {
      expect(validate.batch(wrong)).toBe(false);
      expect(() => readBatchConfig(JSON.stringify(wrong), 'wrong')).toThrow(/^wrong/);
    }
  });
});
