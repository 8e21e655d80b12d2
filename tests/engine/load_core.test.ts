import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { NONE } from '../../web/engine/core/core';
import type { Core, Progress } from '../../web/engine/core/core';
import { loadTestCore } from './support/core';
import { cube, grid, torus } from './support/shapes';

const shell = {
  model: 'shell' as const,
  modeCount: 4,
  thickness: 0.02,
  young: 1e6,
  poisson: 0.3,
  density: 1000,
  unit: 1,
  direction: -1,
  pinned: new Uint32Array(),
  exact: false,
};
const paper = {
  method: 'paper' as const,
  strainWeight: 0.05,
  curvatureWeight: 1,
  qualityWeight: 0.01,
};

/** Everything that the core computes when it simplifies a mesh. */
function results(core: Core) {
  const { mesh } = core.weld(torus().positions, torus().triangles, { tolerance: 0 });
  const modes = core.findModes(mesh, shell);
  const solid = core.findModes(mesh, { ...shell, model: 'solid', pinned: Uint32Array.from([0, 1, 2]) });
  const large = core.weld(torus(96, 90).positions, torus(96, 90).triangles, { tolerance: 0 }).mesh;
  const coarse = core.findModes(large, shell);
  const guidance = core.strainGuidance(mesh, modes, { ordinals: [0, 1], weights: [], p: 2, threshold: 0.2 });
  const curvature = core.meanCurvature(mesh);
  const history = core.simplify(mesh, guidance.rank, curvature.vertex, paper);
  const { mesh: half } = core.meshAt(mesh, history, mesh.triangles.length / 6);
  const fidelity = core.compareFidelity(mesh, half, { ...shell, modeCount: 4 });
  const distance = core.measureSurfaceDistance(mesh, half, 0);
  return {
    mesh,
    modes,
    solid,
    coarse,
    guidance,
    curvature,
    history,
    half,
    fidelity,
    distance,
    quality: core.measureQuality(half),
  };
}

describe('the core', () => {
  it('gives the same bits in both builds and on any number of threads', async () => {
    const expected = results(await loadTestCore(1));
    for (const threads of [2, 3]) expect(results(await loadTestCore(threads))).toEqual(expected);
  });

  it('gives the same results for handles as for plain data, until they are released', async () => {
    const core = await loadTestCore(1);
    const { mesh } = core.weld(torus().positions, torus().triangles, { tolerance: 0 });
    const none = new Float32Array();
    const history = core.simplify(mesh, none, none, { ...paper, method: 'qem' });
    const kept = core.keepMesh(mesh);
    const keptHistory = core.keepHistory(history);
    expect(core.simplify(kept, none, none, { ...paper, method: 'qem' })).toEqual(history);
    for (const faces of [100, 200])
      expect(core.meshAt(kept, keptHistory, faces)).toEqual(core.meshAt(mesh, history, faces));
    core.releaseHistory(keptHistory);
    core.releaseMesh(kept);
    expect(() => core.meshAt(mesh, keptHistory, 100)).toThrow('This history has been released');
    expect(() => core.inspect(kept)).toThrow('This mesh has been released: open the file again.');
  });

  it('offers the functions that its interface names, and no others', async () => {
    const folder = new URL('../../web/engine/core/interface/', import.meta.url);
    const named = readdirSync(folder).flatMap((file) => {
      const [, body = ''] = readFileSync(new URL(file, folder), 'utf8').split(
        /export interface \w+Functions \{/,
      );
      return [...body.matchAll(/^ {2}(\w+)(?:<[^(]*>)?\(/gm)].map(([, name]) => name);
    });
    const { threads, job, peakHeapBytes, heapLimit, ...offered } = await loadTestCore(1);
    expect([threads, job, typeof peakHeapBytes, heapLimit]).toEqual([1, null, 'function', 2 ** 32]);
    expect(Object.keys(offered).sort()).toEqual(named.sort());
  });

  it('exposes a job only if memory is shared', async () => {
    const [single, threaded] = [await loadTestCore(1), await loadTestCore(2)];
    expect([single.threads, single.job]).toEqual([1, null]);
    expect(threaded.threads).toBe(2);
    expect(threaded.job).toHaveLength(4);
    expect(threaded.peakHeapBytes()).toBeGreaterThan(2 ** 20);
  });

  it('returns copies, not views of its memory', async () => {
    const core = await loadTestCore(2);
    const { mesh, vertexOfSource } = core.weld(cube().positions, cube().triangles, { tolerance: 0 });
    expect(mesh.positions.buffer).toBeInstanceOf(ArrayBuffer);
    expect(mesh.positions.buffer.byteLength).toBe(96);
    expect([...vertexOfSource]).not.toContain(NONE);
  });

  it.each([1, 2])('reports its progress by phase names with %i threads', async (threads) => {
    const heard: Progress[] = [];
    const core = await loadTestCore(threads, (progress) => heard.push(progress));
    core.findModes(torus(), shell);
    expect(new Set(heard.map(({ phase }) => phase))).toContain('solving for modes');
    for (const { fraction } of heard) expect(fraction >= 0 && fraction <= 1).toBe(true);
  });

  it('stops a running call when another thread requests it, and still works afterwards', async () => {
    let cancel = () => {};
    const core = await loadTestCore(2, ({ fraction }) => fraction > 0 && cancel());
    const mesh = grid(40, 40);
    cancel = () => void Atomics.store(core.job!, 0, 1);
    const run = () => core.findModes(mesh, { ...shell, modeCount: 12 });
    expect(run).toThrow(expect.objectContaining({ name: 'Cancelled' }));
    cancel = () => {};
    expect(run().modes).toHaveLength(12);
  });

  it('is correct after a hundred calls cancelled at random times, and leaks no memory', async () => {
    let countdown = Infinity;
    const core = await loadTestCore(2, () => {
      if (--countdown === 0) Atomics.store(core.job!, 0, 1);
    });
    const { positions, triangles } = torus(48, 24);
    const solve = (model: 'shell' | 'solid') =>
      core.findModes({ positions, triangles }, { ...shell, model, modeCount: 6 });
    const expected = { shell: solve('shell'), solid: solve('solid') };
    const heap = core.peakHeapBytes();
    let [cancelled, seed] = [0, 1];
    for (let i = 0; i < 100; ++i) {
      seed = (seed * 48271) % 2147483647;
      countdown = 1 + (seed % 120);
      try {
        solve(i % 2 === 0 ? 'shell' : 'solid');
      } catch (error) {
        expect((error as Error).name).toBe('Cancelled');
        ++cancelled;
      }
    }
    countdown = Infinity;
    expect(cancelled).toBeGreaterThan(60);
    expect({ shell: solve('shell'), solid: solve('solid') }).toEqual(expected);
    // The heap grows by a quarter at a time; a hundred leaked factors would fill it many times over.
    expect(core.peakHeapBytes()).toBeLessThan(2 * heap);
  });

  it('throws an Error with its sentence', async () => {
    const core = await loadTestCore(1);
    const outOfRange = () => core.weld(cube().positions, Uint32Array.from([0, 1, 99]), { tolerance: 0 });
    expect(outOfRange).toThrow(/^[A-Z].*\.$/);
    expect(outOfRange).toThrow(Error);
  });
});
