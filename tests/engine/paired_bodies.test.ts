/** Two models whose bodies belong together are compared, tuned and moved as they stand in their scenes. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Document } from '@gltf-transform/core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { runCompare } from '../../web/cli/compare';
import { runOptimize } from '../../web/cli/optimize';
import { runSimulate } from '../../web/cli/simulate';
import { runTune } from '../../web/cli/tune';
import { pairedModel } from '../../web/engine/body/paired_bodies';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import type { Report } from '../../web/engine/report/report';
import { readSettingsFile } from '../../web/engine/report/settings_reader';
import { defaultSettings } from '../../web/engine/settings/options';
import type { TriangleMesh } from '../../web/engine/core/core';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { grid, torus } from './support/shapes';

/** The mesh times `scale`, moved along x. */
const placed = ({ positions, triangles }: TriangleMesh, scale: number, x = 0): TriangleMesh => ({
  positions: positions.map((value, i) => scale * value + (i % 3 === 0 ? x : 0)),
  triangles,
});

/** A document with a mesh of this name per entry, and its node. */
function documentOf(meshes: [string, TriangleMesh][]): Document {
  const document = startDocument();
  for (const [name, mesh] of meshes) addMesh(document, name, [primitiveOf(document, mesh)]);
  return document;
}

const nodeOf = (document: Document, name: string) =>
  document
    .getRoot()
    .listNodes()
    .find((node) => node.getMesh()?.getName() === name)!;

const open = async (document: Document): Promise<OpenModel> => openModel([await glbFile(document)]);

const pair = (original: OpenModel, other: OpenModel): OpenModel =>
  pairedModel(original, other, defaultSettings());

describe('bodies are paired', () => {
  it('by name where both models have the same names, each once, otherwise by their order', async () => {
    const names = ({ bodies }: OpenModel) => bodies.map(({ name }) => name);
    const original = await open(documentOf([['a', grid(2, 2)], ['b', torus()]])); // prettier-ignore
    const turned = await open(documentOf([['b', torus()], ['a', grid(2, 2)]])); // prettier-ignore
    const others = await open(documentOf([['c', grid(2, 2)], ['a', torus()]])); // prettier-ignore
    const one = await open(documentOf([['b', torus()]]));
    expect(names(pair(original, turned))).toEqual(['a', 'b']);
    expect(names(pair(original, others))).toEqual(['c', 'a']);
    expect(names(pair(original, one))).toEqual(['b']);
  });

  it('in the space of the original where a node scales and moves what was scaled and moved back', async () => {
    const original = await open(documentOf([['ring', torus()]]));
    const document = documentOf([['ring', placed(torus(), 100, 50)]]);
    nodeOf(document, 'ring').setScale([0.01, 0.01, 0.01]).setTranslation([-0.5, 0, 0]);
    const [body] = pair(original, await open(document)).bodies;
    body.positions.forEach((value, i) => expect(value).toBeCloseTo(original.bodies[0].positions[i], 5));
    expect(body.own!.scale).toBeCloseTo(0.01, 9);
    expect(body.scale).toBe(1);
  });

  it('unchanged if meshes lie beside each other, or a node scales non-uniformly', async () => {
    const original = await open(documentOf([['ring', torus()]]));
    const beside = documentOf([['ring', torus()]]);
    nodeOf(beside, 'ring').setTranslation([5, 0, 0]);
    const uneven = documentOf([['ring', placed(torus(), 2)]]);
    nodeOf(uneven, 'ring').setScale([0.5, 0.5, 0.7]);
    for (const document of [beside, uneven]) {
      const other = await open(document);
      const [body] = pair(original, other).bodies;
      expect(body.positions).toBe(other.bodies[0].positions);
      expect(body.own).toBeUndefined();
    }
  });
});

describe('a quantized result, which its node scales and translates', () => {
  let folder: string;
  const path = (name: string) => join(folder, name);
  const text = (name: string) => readFileSync(path(name), 'utf8');

  async function report(...words: string[]): Promise<Report> {
    const named = words.map((word) => (/\.(glb|json)$/.test(word) ? path(word) : word));
    const args = parseArguments([...named, '--report', path('r.json'), '--quiet']) as Arguments;
    const run = { compare: runCompare, optimize: runOptimize, simulate: runSimulate, tune: runTune };
    expect(await run[args.command as keyof typeof run](args)).toBe(0);
    rmSync(path('r.json.used'), { force: true });
    const found = JSON.parse(text('r.json')) as Report;
    rmSync(path('r.json'));
    return found;
  }

  beforeAll(async () => {
    folder = mkdtempSync(join(tmpdir(), 'limber-paired-'));
    const bent = grid(12, 12);
    for (let i = 0; i < bent.positions.length; i += 3)
      bent.positions[i + 2] = 2 * Math.sin(0.4 * bent.positions[i] + 0.2 * bent.positions[i + 1]);
    const document = documentOf([['sheet', placed(bent, 100)]]);
    nodeOf(document, 'sheet').setScale([0.01, 0.01, 0.01]).setTranslation([1, 2, 3]);
    writeFileSync(path('in.glb'), (await glbFile(document)).bytes);
    await report('optimize', 'in.glb', 'plain.glb', '--ratio', '0.5');
    await report('optimize', 'in.glb', 'small.glb', '--ratio', '0.5', '--compress', 'quantized');
  });

  afterAll(() => rmSync(folder, { recursive: true }));

  it('is as close to its original as the same result in floats', async () => {
    const plain = await report('compare', 'in.glb', 'plain.glb');
    const small = await report('compare', 'in.glb', 'small.glb');
    expect(small.surface!.hausdorff).toBeCloseTo(plain.surface!.hausdorff, 1);
    expect(small.fidelity!.frequencyErrorMean).toBeCloseTo(plain.fidelity!.frequencyErrorMean!, 0);
  });

  it('is tuned, and simulated with its settings, which are in the space of its own mesh', async () => {
    await report(...'tune in.glb small.glb --solver jolt --pins high:10 --settings s.json'.split(' '));
    const [entry] = readSettingsFile('s.json', text('s.json')).bodies;
    const [body] = (await openModel([{ name: 'small.glb', bytes: new Uint8Array(readFileSync(path('small.glb'))) }])).bodies; // prettier-ignore
    expect(entry.unit).toBeCloseTo(body.scale, 9);
    entry.renderVertices.forEach((vertex, i) =>
      expect(entry.mesh.positions[3 * vertex]).toBeCloseTo(body.positions[3 * i], 6),
    );
    const still = 'simulate in.glb small.glb --settings s.json --pins high:10 --scenario hang --seconds 0.1';
    const moved = await report(...still.split(' '));
    expect(moved.simulation!.deviation!.mean).toBeLessThan(1);
    expect(moved.simulation!.tuned).toBe(true);
  });

  it('keeps floats if a binding has distances from it', async () => {
    await report(...'optimize in.glb bound.glb --ratio 0.5 --compress quantized --bind b.json'.split(' '));
    const bytes = new Uint8Array(readFileSync(path('bound.glb')));
    const { document, bodies } = await openModel([{ name: 'bound.glb', bytes }]);
    const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
    expect(primitive.getAttribute('POSITION')!.getArray()).toBeInstanceOf(Float32Array);
    expect(bodies[0].scale).toBeCloseTo(0.01, 9);
  });
});
