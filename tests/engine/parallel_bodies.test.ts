/** Small bodies of a file are worked on in parallel, with the results that they have alone. */

import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, ParallelName } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { coreCall, callAll, resultOf } from '../../web/engine/stages/many_bodies/core_call';
import type { WorkSpan } from '../../web/engine/stages/many_bodies/file_progress';
import { ValueCache } from '../../web/engine/stages/many_bodies/value_cache';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { cube } from './support/shapes';
import { ball, moved, partsBody, partsScene } from './support/scenes';

const SHELL = { model: 'shell' as const, young: 1e6, poisson: 0.3, density: 1000, thickness: 0.02, unit: 1 };

let core: Core, single: Core;
beforeAll(async () => {
  [core, single] = [await loadTestCore(2), await loadTestCore(1)];
});

/** The core, and how many calls of each function were made in parallel. */
function watched(): { core: Core; together: Map<string, number>; alone: Map<string, number> } {
  const [together, alone] = [new Map<string, number>(), new Map<string, number>()];
  const count = (calls: Map<string, number>, name: string, more: number) =>
    calls.set(name, (calls.get(name) ?? 0) + more);
  const proxy = new Proxy(core, {
    get: (target, name: keyof Core) => {
      const value = target[name];
      if (typeof value !== 'function') return value;
      return (...values: unknown[]) => {
        if (name === 'callAll') count(together, values[0] as ParallelName, (values[1] as unknown[]).length);
        else count(alone, name, 1);
        return (value as (...values: unknown[]) => unknown)(...values);
      };
    },
  });
  return { core: proxy, together, alone };
}

async function optimized(
  by: Core,
  document = partsScene(12),
  changes: Partial<Settings> = {},
  onStage?: (stage: string) => void,
) {
  const model = await openModel([await glbFile(document)]);
  const activity: string[] = [];
  const onActivity = (body: string) => activity.push(body);
  const file = new FileRun(by, model, { guides: true, onActivity, onStage });
  const settings = { ...defaultSettings(), ...changes };
  const asked = { settings, fields: false, faces: null, ratio: 0.5 };
  const output = new FileOutput(file, requestFile(file, asked));
  output.compute();
  return { file, output, activity, bytes: await output.glb() };
}

describe('small bodies', () => {
  it('give the same results with and without threads, to the last byte', async () => {
    const [many, one] = [await optimized(core), await optimized(single)];
    expect(many.bytes).toEqual(one.bytes);
  });

  it('are analysed, reduced, fitted and measured in parallel', async () => {
    const watching = watched();
    await optimized(watching.core);
    // Of twelve parts eight have shapes of their own.
    expect(Object.fromEntries(watching.together)).toMatchObject({
      findModes: 8,
      strainGuidance: 8,
      simplify: 8,
      fitShape: 8,
    });
    for (const name of ['findModes', 'strainGuidance', 'simplify'])
      expect([name, watching.alone.get(name)]).toEqual([name, undefined]);
  });

  // So many that each has few of the faces, and no search is made for fewer after its fit.
  const manyParts = () => partsScene(51);

  it('stop at the same level where a limit of their deviation is met', async () => {
    const [watching, tight] = [watched(), { maxDeviation: 0.4 }];
    const many = await optimized(watching.core, manyParts(), tight);
    const one = await optimized(single, manyParts(), tight);
    expect(many.bytes).toEqual(one.bytes);
    expect(many.output.stopped().filter(({ guard }) => guard).length).toBeGreaterThan(2);
    expect(watching.together.get('isWithinHausdorff')).toBeGreaterThan(8);
    expect(watching.alone.get('isWithinHausdorff') ?? 0).toBeLessThan(3);
  });

  it('have the same further levels, which are guarded and fitted in parallel', async () => {
    const lods = { lods: [0.4, 0.3, 0.2], maxDeviation: 3 };
    const levelsOf = async ({ output }: { output: FileOutput }) =>
      Promise.all(lods.lods.map(async (_, n) => (await output.level(n, `level${n}.glb`)).files[0].bytes));
    const watching = watched();
    const many = await optimized(watching.core, manyParts(), lods);
    const levels = await levelsOf(many);
    expect(levels).toEqual(await levelsOf(await optimized(single, manyParts(), lods)));
    // Of more than eight shapes; levels that stop at the same number of faces are fitted once.
    expect(watching.together.get('fitShape')).toBeGreaterThan(2 * 8);
    const stopped = many.output.values(STAGES.furtherLevels).flat();
    expect(stopped.filter(({ guard }) => guard).length).toBeGreaterThan(2);
    // A fit that goes beyond the limit is made again by itself.
    expect(watching.alone.get('fitShape') ?? 0).toBeLessThan(0.1 * watching.together.get('fitShape')!);
  });

  it('have the same result at a further level with the ratio of the first', async () => {
    const { output } = await optimized(core, partsScene(4), { lods: [0.5], maxDeviation: 2 });
    const first = output.values(STAGES.fitted);
    output.values(STAGES.furtherLevels).forEach(([level], i) => {
      expect(level.result.mesh).toEqual(first[i].result.mesh);
      expect(level.guard).toEqual(first[i].guard);
    });
  });

  it('are fitted by their own stages if fitting them in parallel fails', async () => {
    let stage = '';
    const fittedIn = new Set<string>();
    const failing: Core = {
      ...core,
      callAll: (name, lists) =>
        name === 'fitShape' ? lists.map(() => new Error('There is no fit.')) : core.callAll(name, lists),
      fitShape: (...values) => {
        fittedIn.add(stage);
        return core.fitShape(...values);
      },
    };
    const many = await optimized(failing, partsScene(12), {}, (name) => (stage = name));
    expect([...fittedIn]).toEqual(['fitted']);
    expect(many.bytes).toEqual((await optimized(single)).bytes);
  });

  it('are announced in their order, each one when its own stages run', async () => {
    const { file, activity } = await optimized(core);
    const names = file.usable.map(({ run }) => run.context.body.name);
    const each = activity.filter((name, i) => name !== activity[i - 1]);
    expect(each.slice(-names.length)).toEqual(names);
  });

  it('count the time that was spent on them together', async () => {
    const { file, output } = await optimized(core);
    const { timings } = output.report({}, []);
    expect(timings.modes).toBeGreaterThan(0);
    expect(timings.fit).toBeGreaterThan(0);
    expect(file.usable[0].run.secondsOf(STAGES.prepared, defaultSettings())).toBeGreaterThan(0);
  });

  it('leave large ones to all threads', async () => {
    const document = startDocument();
    addMesh(document, 'large', [primitiveOf(document, ball(60))]);
    addMesh(document, 'small', [
      primitiveOf(
        document,
        moved(ball(8), (x, y, z) => [x, 2 * y, z]),
      ),
    ]);
    const watching = watched();
    await optimized(watching.core, document);
    expect(watching.together.get('simplify')).toBeUndefined();
    expect(watching.alone.get('simplify')).toBe(2);
  });
});

describe('progress on many bodies', () => {
  /** The shares of the work that a page shows while files of parts are opened, reduced by half and reduced again. */
  async function shares(count: number, threads: number) {
    let span: WorkSpan | null = null;
    let told: number[] = [];
    const tell = (fraction: number) => {
      if (span) told.push(span.done + fraction * (span.next - span.done));
    };
    const watching = await loadTestCore(threads, ({ fraction }) => tell(fraction));
    const onProgress = (fresh: WorkSpan | null) => {
      span = fresh;
      tell(0);
    };
    const model = await openModel([await glbFile(partsScene(count))]);
    const file = new FileRun(watching, model, { guides: true, onProgress });
    const during = (work: () => void): number[] => {
      file.progress.restart();
      told = [];
      work();
      expect(span).toBeNull();
      return told;
    };
    const asked = { settings: defaultSettings(), fields: false, faces: null, ratio: 0.5 };
    const reduce = () => new FileOutput(file, requestFile(file, asked)).compute();
    const opening = during(() => file.prepare(defaultSettings()));
    return { opening, reducing: during(reduce), again: during(reduce) };
  }

  const leaps = (values: number[]): number[] =>
    [...values, 1].map((value, i) => value - (i > 0 ? values[i - 1] : 0));

  for (const threads of [1, 2])
    it(`never goes back and makes no leap, threads: ${threads}`, async () => {
      const { opening, reducing, again } = await shares(64, threads);
      expect(Math.max(...leaps(opening))).toBeCloseTo(1 / 64, 6);
      for (const values of [opening, reducing]) expect(Math.min(...leaps(values))).toBeGreaterThanOrEqual(0);
      // The largest piece is the guard of all parts together, which is many calls.
      expect(Math.max(...leaps(reducing))).toBeLessThan(threads > 1 ? 0.2 : 0.02);
      expect(again).toEqual([]);
    });
});

describe('a comparison of bodies of many parts', () => {
  it('solves for the modes of small parts together, as findModes does', async () => {
    const phases = new Set<string>();
    const watching = await loadTestCore(1, ({ phase }) => phases.add(phase));
    const [body, other] = [partsBody(3), moved(partsBody(3), (x, y, z) => [x, 1.1 * y, z])];
    const found = watching.compareFidelity(body, other, { ...SHELL, modeCount: 4 });
    expect(phases).toContain('solving for modes');
    expect(phases).not.toContain('assembling matrices'); // that is for a part alone
    expect(found.frequencyErrorMean).toBeGreaterThan(1);
    expect(core.compareFidelity(body, other, { ...SHELL, modeCount: 4 })).toEqual(found);
  });
});

describe('parallel calls', () => {
  const distance = (scale: number) => {
    const mesh = cube();
    const other = moved(mesh, (x, y, z) => [scale * x, scale * y, scale * z]);
    return coreCall('measureSurfaceDistance', mesh, other, 0);
  };

  it('are made once for equal arguments, and give what a single call gives', () => {
    const watching = watched();
    const cache = new ValueCache(10);
    callAll(watching.core, cache, [distance(2), distance(3), distance(2)]);
    callAll(watching.core, cache, [distance(3)]);
    expect(watching.together.get('measureSurfaceDistance')).toBe(2);
    expect(resultOf(watching.core, cache, distance(3))).toEqual(
      core.measureSurfaceDistance(...distance(3).values),
    );
    expect(watching.alone.get('measureSurfaceDistance')).toBeUndefined();
  });

  it('return an Error for a call that fails, which is then repeated alone', () => {
    const options = { ...SHELL, modeCount: 2, direction: -1, pinned: new Uint32Array(), exact: false };
    const [wrong, right] = [{ ...options, poisson: 0.9 }, options].map((one) =>
      coreCall('findModes', cube(), one),
    );
    const [failed, found] = core.callAll('findModes', [wrong.values, right.values]);
    expect(failed).toBeInstanceOf(Error);
    expect(found).toEqual(core.findModes(...right.values));
    const cache = new ValueCache(10);
    callAll(core, cache, [wrong]);
    expect(() => resultOf(core, cache, wrong)).toThrow((failed as Error).message);
  });

  it('can be made for every function that the interface lists', () => {
    const names: Record<ParallelName, true> = {
      findModes: true,
      strainGuidance: true,
      simplify: true,
      fitShape: true,
      measureSurfaceDistance: true,
      measureHausdorff: true,
      isWithinHausdorff: true,
    };
    for (const name of Object.keys(names) as ParallelName[]) expect(core.callAll(name, [])).toEqual([]);
  });

  it('are refused for other functions', () => {
    expect(() => core.callAll('weld' as ParallelName, [])).toThrow('makes no calls of "weld" in parallel');
  });
});
