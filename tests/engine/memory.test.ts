// The memory of the core is bounded where that is asked for, and what needs more is refused before the work.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, afterEach, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { coreMemory, readMegabytes } from '../../web/engine/core/memory_size';
import { loadCore } from '../../web/engine/core/load_core';
import type { Body } from '../../web/engine/document/model';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { admitBodies } from '../../web/engine/stages/admission';
import type { Caller } from '../../web/engine/stages/admission';
import { FileRun } from '../../web/engine/stages/file_run';
import { WorkSession } from '../../web/library/work/session';
import { loadTestCore } from './support/core';
import { SQUARE_OBJ, textFile } from './support/files';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { ball } from './support/scenes';

const root = join(import.meta.dirname, '..', '..');
const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;
const folder = mkdtempSync(join(tmpdir(), 'limber-memory-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** A binary STL whose bytes are all there; `faces` of them, each alone. */
function stl(faces: number): Buffer {
  const bytes = Buffer.alloc(84 + 50 * faces);
  bytes.writeUInt32LE(faces, 80);
  for (let f = 0; f < faces; ++f)
    [f, 0, 0, f + 1, 0, 0, f, 1, 0].forEach((value, i) =>
      bytes.writeFloatLE(value, 84 + 50 * f + 12 + 4 * i),
    );
  return bytes;
}

describe('a size of memory', () => {
  it('is read with and without its unit', () => {
    expect(['512M', '512', '2g'].map((text) => readMegabytes(text, '--memory'))).toEqual([512, 512, 2048]);
    expect(coreMemory('64M', '--memory')).toBe(64 * 2 ** 20);
  });

  it.each(['', '1.5G', '-1', '2T', '1e3', '63M', '5G'])('is refused: "%s"', (text) => {
    expect(() => coreMemory(text, '--memory')).toThrow(
      /^--memory is .*: (give a size such as 512M or 2G|the core takes)/,
    );
  });
});

describe('the core', () => {
  it.each([1, 2])('uses no more memory than it is given, on %i threads', async (threads) => {
    const memory = 100 * 2 ** 20;
    const core = await loadCore({ threads, wasmFolder, memory });
    expect(core.heapLimit).toBe(memory);
    const count = 4_000_000;
    const mesh = { positions: new Float32Array(3 * count), triangles: new Uint32Array(3 * count) };
    expect(() => core.inspect(mesh)).toThrow('Not enough memory');
    expect(core.peakHeapBytes()).toBeLessThanOrEqual(memory);
    // It goes on with what fits.
    const small = {
      positions: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
      triangles: new Uint32Array([0, 1, 2]),
    };
    expect(core.inspect(small)).toMatchObject({ faces: 1 });
  });
});

describe('with less address space than the core may use', () => {
  const { Memory } = WebAssembly;
  afterEach(() => (WebAssembly.Memory = Memory));

  it.each([1, 2])('half, a quarter and so on is reserved, on %i threads', async (threads) => {
    const space = 300 * 2 ** 20;
    WebAssembly.Memory = class extends Memory {
      constructor(about: WebAssembly.MemoryDescriptor) {
        if (about.maximum! * 2 ** 16 > space) throw new RangeError('could not allocate memory');
        super(about);
      }
    };
    const core = await loadCore({ threads, wasmFolder });
    expect(core.heapLimit).toBe(256 * 2 ** 20);
    expect(core.inspect({ positions: new Float32Array(9), triangles: new Uint32Array() }).faces).toBe(0);
  });

  it('says that there is none at all', async () => {
    WebAssembly.Memory = class extends Memory {
      constructor() {
        super({ initial: 0 });
        throw new RangeError('WebAssembly.Memory(): could not allocate memory');
      }
    };
    await expect(loadCore({ threads: 1, wasmFolder })).rejects.toThrow(
      /^The core gets no memory from the system: close .*, or allow more address space \(ulimit -v\)/,
    );
  });
});

describe('a model that needs more', () => {
  it('is refused by its faces, in one sentence with a cure', () => {
    const limit = (megabytes: number, caller: Caller) => ({ heapLimit: megabytes * 2 ** 20, caller });
    const body = { name: 'city', indices: new Uint32Array(3 * 1_000_000) } as Body;
    expect(() => admitBodies([body], limit(512, 'page'))).not.toThrow();
    const needs =
      'city has 1,000,000 faces, for which the core needs about 0.4 GB of memory, but it may use only 0.3 GB';
    expect(() => admitBodies([body], limit(256, 'command line'))).toThrow(
      `${needs}: raise --memory (at most 4G), or reduce the mesh in parts.`,
    );
    expect(() => admitBodies([body], limit(256, 'page'))).toThrow(
      `${needs}: add ?memory=4G to the address, or reduce the mesh in parts.`,
    );
  });

  it('is refused in the library in a sentence without flags', async () => {
    const model = await openModel([textFile('a.obj', SQUARE_OBJ)]);
    const session = new WorkSession({ heapLimit: 100 } as Core, defaultSettings(), () => {});
    expect(() => session.prepare(model)).toThrow(/ GB: reduce the mesh in parts\.$/);
  });

  it('is refused if only its fit needs more, unless there is no fit', async () => {
    const document = startDocument();
    addMesh(document, 'ball', [primitiveOf(document, ball(20))]);
    const model = await openModel([await glbFile(document)]);
    const faces = model.bodies[0].indices.length / 3;
    const core = { ...(await loadTestCore(1)), heapLimit: 600 * faces };
    const settings = defaultSettings();
    const run = (guides: boolean) => new FileRun(core, model, { guides });
    expect(() => run(true).prepare(settings)).toThrow(/^ball has .*: use --fit off, raise --memory/);
    expect(run(true).prepare({ ...settings, fit: 'off' })).toEqual([]);
    expect(run(false).prepare(settings)).toEqual([]);
  });

  it('is refused by the command line before any work, and nothing is written', () => {
    const [input, output] = [join(folder, 'large.stl'), join(folder, 'out.glb')];
    writeFileSync(input, stl(200_000));
    const program = join(root, 'dist', 'cli', 'limber.mjs');
    const words = ['optimize', input, output, '--memory', '64M'];
    const { status, stderr } = spawnSync(process.execPath, [program, ...words], { encoding: 'utf8' });
    expect(stderr.trim().split('\n')).toEqual([
      expect.stringMatching(/^limber: large has 200,000 faces, .*: raise --memory \(at most 4G\)/),
    ]);
    expect([status, existsSync(output)]).toEqual([1, false]);
  });
});
