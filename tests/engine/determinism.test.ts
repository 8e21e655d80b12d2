/** Every stage has the same bits on any number of threads, in both builds of the core. */

import { createHash } from 'node:crypto';
import type { Hash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { runOfModel } from './support/runs';

type StageName = keyof typeof STAGES;
const NAMES = Object.keys(STAGES) as StageName[];

/** Adds all numbers, texts and lists of a value; what is no plain data, such as the document of the file, is left out. */
function addTo(hash: Hash, value: unknown): void {
  if (ArrayBuffer.isView(value)) {
    hash.update(`${value.constructor.name} ${value.byteLength} `);
    hash.update(new Uint8Array(value.buffer, value.byteOffset, value.byteLength));
  } else if (Array.isArray(value) || value instanceof Set || value instanceof Map) {
    hash.update('[');
    for (const entry of value) addTo(hash, entry);
    hash.update(']');
  } else if (typeof value === 'object' && value !== null) {
    if (Object.getPrototypeOf(value) !== Object.prototype) return;
    for (const [name, entry] of Object.entries(value)) {
      hash.update(`${name}:`);
      addTo(hash, entry);
    }
  } else if (typeof value !== 'function') hash.update(`${String(value)};`);
}

/** The hash of each stage's value for a sample, by its name. */
async function hashes(sample: string, threads: number): Promise<Record<string, string>> {
  const core = await loadTestCore(threads);
  expect(core.threads).toBe(threads);
  const address = new URL(`../../public/samples/${sample}.glb`, import.meta.url);
  const model = await openModel([{ name: `${sample}.glb`, bytes: new Uint8Array(readFileSync(address)) }]);
  const run = runOfModel(core, model);
  const settings = {
    ...defaultSettings(),
    targetFaces: 400,
    fields: true,
    solver: 'hinge-shell' as const,
    lods: [0.2],
  };
  const entries = NAMES.map((name) => {
    const hash = createHash('sha256');
    addTo(hash, run.get(STAGES[name] as (typeof STAGES)['prepared'], settings));
    return [name, hash.digest('hex')] as const;
  });
  run.dispose();
  return Object.fromEntries(entries);
}

describe('the hash of every stage', () => {
  it.each(['bar', 'cloth'])('of %s is that of one thread on two and four', async (sample) => {
    const one = await hashes(sample, 1);
    for (const threads of [2, 4]) expect(await hashes(sample, threads)).toEqual(one);
    // A stage without data would have the hash of nothing, and equal ones would be the same value.
    expect(new Set(Object.values(one)).size).toBeGreaterThan(NAMES.length / 2);
    const empty = createHash('sha256').digest('hex');
    for (const name of ['prepared', 'modes', 'history', 'level', 'fitted', 'tuned', 'written'])
      expect(one[name], name).not.toBe(empty);
  });
});
