/** Which tasks the page runs after a cancel, with a worker that answers when a test says so. */

import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import { closeQueue, fillQueue } from '../../web/app/state/queue/queue';
import { refusedLock } from '../../web/app/state/locks';
import { cancelRunning, openFiles, resume, showBody, startRunner } from '../../web/app/state/runner';
import { redo, restoreUndo, undo } from '../../web/app/state/undo';
import { changeSettings, isHistoryStale, results, status, view, wants } from '../../web/app/state/store';
import { twin } from '../../web/app/state/twin';
import { CANCELLED } from '../../web/app/worker/protocol';
import { defaultSettings } from '../../web/engine/settings/options';
import { keyOf } from '../../web/engine/stages/stage';
import { STAGES } from '../../web/engine/stages/stages';

const page = vi.hoisted(() => {
  // The state of the page asks for the colour scheme.
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('addEventListener', () => {});
  interface Call {
    name: string;
    resolve(value: unknown): void;
    reject(error: Error): void;
  }
  const calls: Call[] = [];
  const complaints: unknown[] = [];
  const worker = new Proxy(
    {},
    {
      get: (_target, name: string) => () =>
        new Promise((resolve, reject) => calls.push({ name, resolve, reject })),
    },
  );
  const client = {
    canStop: true,
    threads: 1,
    ready: () => Promise.resolve(),
    call: (make: (remote: typeof worker) => Promise<unknown>) => make(worker),
    open: () => new Promise((resolve, reject) => calls.push({ name: 'open', resolve, reject })),
    cancel: () => calls.shift()?.reject(new Error('cancelled')),
  };
  return { calls, complaints, client };
});

vi.mock('../../web/app/state/running', () => ({
  client: page.client,
  complain: (error: unknown) => page.complaints.push(error),
  replayer: { open: () => {} },
  whileBusy: (_what: string, make: () => Promise<unknown>) => make(),
}));
vi.mock('../../web/app/state/work/kept_work', () => ({ contentKey: () => Promise.resolve(null) }));
vi.mock('../../web/app/state/saved_session', () => ({ saveFiles: () => {}, startSaving: () => {} }));
vi.mock('../../web/app/state/replay', () => ({ isReplayed: { value: true }, startReplay: () => {} }));

const rest = () => new Promise((resolve) => setTimeout(resolve));
const mesh = { positions: new Float32Array(9), triangles: Uint32Array.of(0, 1, 2) };
const contents = { vertexColours: false, materials: 0, animations: 0 };
const file = { name: 'a.obj', bodies: [{ faces: 1 }], first: 0, contents };

/** What the worker answers. The tests do not look at other results. */
const ANSWERS: Record<string, () => unknown> = {
  open: () => file,
  prepare: () => ({ mesh }),
  pins: () => ({ text: '', vertices: new Uint32Array() }),
  modes: () => ({ key: keyOf(STAGES.modes, wants.settings.value), shapes: [] }),
  fit: () => ({ key: '', result: null }),
  history: () => ({ faces: 1, key: keyOf(STAGES.history, wants.settings.value) }),
};

/** Answers the running calls up to one of this name, which stays; returns their names. */
async function answerUntil(last: string | null): Promise<string[]> {
  const names: string[] = [];
  for (await rest(); page.calls.length > 0 && page.calls[0].name !== last; await rest()) {
    const { name, resolve } = page.calls.shift()!;
    names.push(name);
    resolve(ANSWERS[name]?.());
  }
  return names;
}

async function open(): Promise<void> {
  void openFiles([]);
  await answerUntil('pins');
}

/** Opens a file, cancels its modes and goes on to the Reduce step. */
async function reduceWithoutModes(): Promise<void> {
  await open();
  await answerUntil('modes');
  cancelRunning();
  await rest();
  view.step.value = 'reduce';
}

beforeAll(startRunner);

afterEach(async () => {
  view.step.value = 'model';
  await answerUntil(null);
  page.complaints.length = 0;
});

it('nothing follows from a cancelled history, which is offered again until it is computed', async () => {
  await open();
  await answerUntil(null);
  changeSettings({ strainWeight: wants.settings.value.strainWeight + 1 });
  await answerUntil('history');
  cancelRunning();
  await rest();
  expect(status.paused.value).toEqual(['Collapsing edges']);
  view.step.value = 'reduce';
  // The slider comes to rest.
  await new Promise((resolve) => setTimeout(resolve, 250));
  expect(await answerUntil(null)).toEqual([]);
  expect([isHistoryStale.value, status.paused.value]).toEqual([true, ['Collapsing edges']]);
  resume();
  expect(await answerUntil(null)).toEqual(expect.arrayContaining(['history', 'fit', 'measure']));
  expect([isHistoryStale.value, status.paused.value]).toEqual([false, []]);
});

it('cancelled work is offered again while other work runs', async () => {
  await reduceWithoutModes();
  expect(await answerUntil(null)).toContain('curvature');
  expect([results.modes.value, status.paused.value]).toEqual([null, ['Finding modes']]);
  resume();
  expect(await answerUntil(null)).toContain('modes');
  expect(status.paused.value).toEqual([]);
});

it('work that is restarted on other inputs does not count as cancelled by the user', async () => {
  await reduceWithoutModes();
  await answerUntil('history');
  changeSettings({ qualityWeight: wants.settings.value.qualityWeight + 1 });
  expect(await answerUntil(null)).toContain('history');
  expect(isHistoryStale.value).toBe(false);
  expect(status.paused.value).toEqual(['Finding modes']);
});

it('cancelled work restarts at once if its inputs change before it has stopped', async () => {
  await open();
  await answerUntil('history');
  cancelRunning();
  changeSettings({ qualityWeight: wants.settings.value.qualityWeight + 1 });
  expect(await answerUntil(null)).toContain('history');
  expect(status.paused.value).toEqual([]);
});

it('a cancel that follows a change of the inputs is of what would run with them', async () => {
  await open();
  await answerUntil('history');
  changeSettings({ qualityWeight: wants.settings.value.qualityWeight + 1 });
  cancelRunning();
  await rest();
  expect([page.calls, status.paused.value]).toEqual([[], ['Collapsing edges']]);
});

it('a file is not opened where that is cancelled, and the earlier one stays without a notice', async () => {
  await open();
  await answerUntil(null);
  const { opened } = results;
  const before = opened.value;
  void openFiles([]);
  await rest();
  expect(page.calls.map(({ name }) => name)).toEqual(['open']);
  cancelRunning();
  await rest();
  expect([opened.value, page.calls, page.complaints]).toEqual([before, [], []]);
  void openFiles([]);
  await rest();
  page.calls.shift()!.reject(new Error(CANCELLED));
  await rest();
  expect(page.complaints).toEqual([]);
});

/** A file of several bodies in place of the usual one, for as long as `make` runs. */
async function withBodies(bodies: object[], make: () => Promise<void>): Promise<void> {
  const usual = file.bodies;
  file.bodies = bodies as typeof usual;
  await make().finally(() => (file.bodies = usual));
}

it('an answer that has left the worker as another body is chosen is not shown for that one', () =>
  withBodies([{ faces: 1 }, { faces: 1 }], async () => {
    await open();
    await answerUntil('modes');
    const [{ resolve }] = page.calls;
    // The worker has answered, so that there is nothing left to cancel.
    page.calls.shift();
    resolve({ key: keyOf(STAGES.modes, wants.settings.value), shapes: ['of the first body'] });
    showBody(1);
    await rest();
    expect(results.modes.value).toBeNull();
    await answerUntil(null);
    expect(results.modes.value).toMatchObject({ shapes: [] });
  }));

it('Undo takes back changes made at other bodies, and shows the body of each', () =>
  withBodies([{ faces: 1 }, { faces: 1 }], async () => {
    await open();
    const { density } = wants.settings.value;
    const now = () => [wants.settings.value.density, wants.body.value];
    changeSettings({ density: density + 1 });
    showBody(1);
    changeSettings({ density: density + 2 });
    showBody(0);
    const seen = [undo, undo, redo, redo].map((go) => {
      go();
      return now();
    });
    expect(seen).toEqual([
      [density + 1, 1],
      [density, 0],
      [density + 1, 0],
      [density + 2, 1],
    ]);
    expect(await answerUntil(null)).toContain('prepare');
  }));

it('a step of Undo for a body that cannot be used takes its change back, and the shown body stays', () =>
  withBodies([{ faces: 1, health: null }, { faces: 1 }], async () => {
    file.first = 1;
    await open().finally(() => (file.first = 0));
    restoreUndo({ past: ['density=1234', 'density=1234&body=9'], future: [] });
    undo();
    undo();
    expect([wants.settings.value.density, wants.body.value]).toEqual([1234, 1]);
  }));

it('a sentence on a refused text is not shown for another body, nor for another file', () =>
  withBodies([{ faces: 1 }, { faces: 1 }], async () => {
    await open();
    const refusal = { text: 'vertices:9', why: 'The body has no such vertex.' };
    status.refusedPins.value = refusal;
    showBody(1);
    expect(status.refusedPins.value).toBeNull();
    refusedLock.value = status.refusedPins.value = refusal;
    await answerUntil(null);
    await open();
    expect([refusedLock.value, status.refusedPins.value]).toEqual([null, null]);
  }));

it('a link for a body that cannot be used shows the first one that can', () =>
  withBodies([{ faces: 1 }, { faces: 1, health: null }], async () => {
    const asked = { settings: wants.settings.value, faces: null, own: new Map(), body: 1, file: null };
    void openFiles([], { asked });
    await answerUntil('pins');
    expect(wants.body.value).toBe(0);
  }));

describe('another model', () => {
  const ofUse = {
    solver: 'blender',
    tune: 'vertex',
    engine: 'mass=2',
    bendRatio: 0.5,
    massRule: 'area',
  } as const;
  const use = (): void => {
    changeSettings({ ...ofUse, lods: [0.25], density: 7 });
    twin.wantsTuned.value = true;
  };

  it('starts without the solver, parameters and levels of the last one', async () => {
    await open();
    use();
    await open();
    const { solver, tune, engine, bendRatio, massRule, lods } = defaultSettings();
    expect(wants.settings.value).toMatchObject({
      solver,
      tune,
      engine,
      bendRatio,
      massRule,
      lods,
      density: 7,
    });
    expect(twin.wantsTuned.value).toBe(false);
  });

  it('starts without how the last one was read and what it could touch, in the format chosen for it', async () => {
    await open();
    const ofPerson = { format: 'ply', compress: 'draco', lodStyle: 'nodes' } as const;
    changeSettings({ ...ofPerson, unit: 0.01, weld: 0.1, colliders: 'ball:0,0,0,1', exclude: 'Eye*' });
    await open();
    const { unit, weld, colliders, exclude } = defaultSettings();
    expect(wants.settings.value).toMatchObject({ ...ofPerson, unit, weld, colliders, exclude });
  });

  it('has what a link asks of it', async () => {
    await open();
    const settings = { ...defaultSettings(), ...ofUse };
    void openFiles([], { asked: { settings, faces: null, own: new Map(), body: 0, file: null } });
    await answerUntil('pins');
    expect(wants.settings.value).toEqual(settings);
  });

  it('of the same queue keeps them, as its models have one setting', async () => {
    const files = [{ name: 'b.obj', bytes: new Uint8Array() }];
    fillQueue([{ name: 'b.obj', files }]);
    await open();
    use();
    void openFiles(files);
    await answerUntil('pins');
    expect(wants.settings.value).toMatchObject({ ...ofUse, lods: [0.25] });
    closeQueue();
  });
});

it('what is tuned for all solvers is asked for one file alone', async () => {
  await open();
  twin.wantsGeneric.value = true;
  await open();
  expect(twin.wantsGeneric.value).toBe(false);
});

it('what is tuned for all solvers can be asked for again after a failure', async () => {
  await open();
  view.step.value = 'test';
  await answerUntil(null);
  for (let asked = 0; asked < 2; asked++) {
    twin.wantsGeneric.value = true;
    await answerUntil('genericFiles');
    page.calls.shift()!.reject(new Error('There is not enough memory.'));
    await rest();
    expect(twin.wantsGeneric.value).toBe(false);
  }
  expect(page.complaints.splice(0)).toHaveLength(2);
});
