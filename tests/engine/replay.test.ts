/** The page's replay of a history apart from the worker that has made it, and what is handed over between workers. */

import { beforeAll, describe, expect, it } from 'vitest';
import { buffersOf, copyOf } from '../../web/app/worker/handing_over';
import { Replay } from '../../web/app/worker/replay';
import type { HandedHistory } from '../../web/app/worker/replay';
import type { Core } from '../../web/engine/core/core';
import { faceCount } from '../../web/engine/core/mesh';
import { defaultSettings } from '../../web/engine/settings/options';
import type { BodyRun } from '../../web/engine/stages/body_run';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { runOfMesh } from './support/runs';
import { torus } from './support/shapes';

const settings = defaultSettings();

/** What the worker hands over, after the copy that a message makes. */
function handed(run: BodyRun, id: string, change: Partial<typeof settings> = {}): HandedHistory {
  const own = { ...settings, ...change };
  const mesh = run.get(STAGES.prepared, own).mesh;
  return structuredClone({ id, mesh, history: run.get(STAGES.history, own) });
}

describe('a replayed history', () => {
  let threaded: Core;
  let alone: Core;
  beforeAll(async () => {
    [threaded, alone] = [await loadTestCore(2), await loadTestCore(1)];
  });

  it('gives the meshes of the worker that computed it, bit by bit', async () => {
    const mesh = torus(48, 24);
    const run = runOfMesh(threaded, mesh);
    const replay = new Replay(alone);
    replay.keep(handed(run, 'a'));
    for (const targetFaces of [faceCount(mesh), 1500, 801, 200, 0])
      expect(await replay.meshAt('a', targetFaces)).toEqual(
        run.get(STAGES.level, { ...settings, targetFaces }),
      );
    run.dispose();
  });

  it('keeps mirror images together', async () => {
    const run = runOfMesh(threaded, torus(48, 24));
    const mirrored = { ...settings, symmetry: 'on' as const };
    const replay = new Replay(alone);
    replay.keep(handed(run, 'a', { symmetry: 'on' as const }));
    for (const targetFaces of [1001, 777])
      expect(await replay.meshAt('a', targetFaces)).toEqual(
        run.get(STAGES.level, { ...mirrored, targetFaces }),
      );
    run.dispose();
  });

  it('waits for a history in transit, and gives nothing of a replaced one', async () => {
    const run = runOfMesh(threaded, torus());
    const replay = new Replay(alone);
    const asked = replay.meshAt('b', 200);
    replay.keep(handed(run, 'a'));
    const before = await replay.meshAt('a', 200);
    replay.keep(handed(run, 'b', { strainWeight: settings.strainWeight + 1 }));
    expect(await replay.meshAt('a', 200)).toBeNull();
    expect(await asked).not.toBeNull();
    expect(before).not.toBeNull();
    expect(await replay.meshAt('b', 200)).toEqual(await asked);
    run.dispose();
  });

  it('says why the core cannot keep it, and keeps the next one', async () => {
    const run = runOfMesh(threaded, torus());
    let hasMemory = false;
    const keepHistory: Core['keepHistory'] = (history) => {
      if (!hasMemory) throw new Error('No memory.');
      return alone.keepHistory(history);
    };
    const replay = new Replay({ ...alone, keepHistory });
    const asked = replay.meshAt('a', 200);
    replay.keep(handed(run, 'a'));
    await expect(asked).rejects.toThrow('No memory.');
    hasMemory = true;
    replay.keep(handed(run, 'b'));
    expect(await replay.meshAt('a', 200)).toBeNull();
    expect(await replay.meshAt('b', 200)).not.toBeNull();
    run.dispose();
  });
});

describe('a value that is handed over', () => {
  it('has copies of the arrays, and the same copy if the original has an array twice', () => {
    const shared = Float32Array.of(1, 2, 3);
    const value = {
      a: shared,
      list: [{ shared }],
      words: ['x', null],
      part: Uint8Array.of(1, 2, 3, 4).subarray(1, 3),
    };
    const copy = copyOf(value);
    expect(copy).toEqual(value);
    expect(copy.list[0].shared).toBe(copy.a);
    expect(buffersOf(copy)).toEqual([copy.a.buffer, copy.part.buffer]);
    expect(copy.part.buffer.byteLength).toBe(2);
    copy.a[0] = 9;
    expect(shared[0]).toBe(1);
  });
});
