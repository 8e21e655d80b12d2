/** A stage runs again exactly when a setting that it reads has changed; the page and the command line write the same files. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { exportAll } from '../../web/app/worker/exporting';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { runOptimize } from '../../web/cli/optimize';
import { withPaint } from '../../web/engine/settings/paint_text';
import type { Core } from '../../web/engine/core/core';
import { vertexCount } from '../../web/engine/core/mesh';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { defaultSettings, OPTIONS } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { BodyRun } from '../../web/engine/stages/body_run';
import { FileRun } from '../../web/engine/stages/file_run';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { fittedDeviationsStage } from '../../web/engine/stages/budget/fitted_deviations';
import { fitSettings } from '../../web/engine/stages/fit';
import { declareStage, keyOf } from '../../web/engine/stages/stage';
import type { AnyStage, RunSettings, RunSettingName } from '../../web/engine/stages/stage';
import { STAGES } from '../../web/engine/stages/stages';
import { together } from './support/bodies';
import { loadTestCore } from './support/core';
import { textFile } from './support/files';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { butterfly, grid, toObj, torus } from './support/shapes';

type StageName = keyof typeof STAGES;
const NAMES = Object.keys(STAGES) as StageName[];

/** The stages that read each setting directly, for a run with the settings `everything`. */
const READERS: Record<RunSettingName, StageName[]> = {
  weld: ['prepared'],
  symmetry: ['prepared'],
  pins: ['pinned'],
  lock: ['constraints'],
  keep: ['constraints'],
  paint: ['constraints'],
  model: ['modes'],
  modeCount: ['modes'],
  direction: ['modes'],
  exact: ['modes'],
  young: ['modes', 'fitted', 'calibration', 'writtenLevels', 'tuned', 'tunedLevels'],
  poisson: [
    'modes',
    'fitted',
    'furtherLevels',
    'deviationMarks',
    'calibration',
    'writtenLevels',
    'tuned',
    'tunedLevels',
  ],
  density: ['modes', 'fitted', 'calibration', 'writtenLevels', 'tuned', 'tunedLevels'],
  thickness: [
    'modes',
    'fitted',
    'furtherLevels',
    'deviationMarks',
    'calibration',
    'writtenLevels',
    'tuned',
    'tunedLevels',
  ],
  unit: ['modes', 'fitted', 'calibration', 'writtenLevels', 'tuned', 'tunedLevels'],
  modes: ['guidance'],
  modeWeights: ['guidance'],
  p: ['guidance'],
  strainThreshold: ['guidance'],
  method: ['history', 'fitted', 'furtherLevels', 'deviationMarks', 'explanation'],
  strainWeight: ['history', 'explanation'],
  curvatureWeight: ['history', 'explanation'],
  qualityWeight: ['history', 'explanation'],
  sizeWeight: ['history', 'explanation'],
  maxDeviation: ['history', 'explanation', 'fitted', 'furtherLevels', 'deviationMarks'],
  perBody: [],
  levelFaces: ['furtherLevels'],
  minAngle: ['history', 'explanation', 'fitted', 'furtherLevels', 'deviationMarks'],
  borders: ['history', 'explanation'],
  seams: ['history', 'explanation', 'fitted', 'furtherLevels', 'deviationMarks'],
  creases: ['history', 'explanation'],
  fit: ['fitted', 'furtherLevels', 'deviationMarks'],
  maxFrequencyError: ['fitted'],
  targetFaces: ['level', 'fitted', 'explanation'],
  fewestFaces: ['history'],
  lods: ['furtherLevels'],
  solver: ['fitted', 'tuned', 'tunedLevels'],
  tune: ['fitted', 'tuned', 'tunedLevels'],
  engine: ['fitted', 'tuned', 'tunedLevels'],
  bendRatio: ['fitted', 'tuned', 'tunedLevels'],
  massRule: ['fitted', 'tuned', 'tunedLevels'],
  calibrate: ['written', 'writtenLevels'],
  fields: ['written', 'writtenLevels'],
  // Only simulations and the core itself read these.
  scenario: [],
  material: [],
  seconds: [],
  substeps: [],
  converge: [],
  damping: [],
  selfCollision: [],
  colliders: [],
  friction: [],
  mesh: [],
  materialName: [],
  exclude: [],
  // The writer of the file reads these.
  format: [],
  compress: [],
  lodStyle: [],
  dropExtensions: [],
  threads: [],
};

/** Settings that have no effect for a method. */
const WITHOUT_EFFECT: Record<Settings['method'], RunSettingName[]> = {
  limber: ['curvatureWeight'],
  paper: ['sizeWeight', 'seams'],
  qem: ['strainWeight', 'curvatureWeight', 'qualityWeight'],
};

const mesh = butterfly(2, 3);

/** A value other than the default for every setting. */
const OTHER: RunSettings = {
  ...{ method: 'qem', model: 'shell', modeCount: 5, modes: [1], modeWeights: [3, 1], p: Infinity },
  ...{ strainThreshold: 0.2, direction: 'x', pins: 'high:30', exact: true },
  ...{ strainWeight: 5, curvatureWeight: 2, qualityWeight: 0.3, sizeWeight: 0.05 },
  ...{ fit: 'off', maxDeviation: 2, minAngle: 12, maxFrequencyError: 95, lods: [0.8, 0.3] },
  ...{ borders: 'fixed', seams: 'cross', symmetry: 'x', creases: 8, keep: '_KEEP', lock: 'low:20' },
  paint: withPaint(
    '',
    0,
    Uint8Array.from({ length: vertexCount(mesh) }, (_, v) => v % 9),
  ),
  ...{ young: 2e6, poisson: 0.2, density: 500, thickness: 3, unit: 0.1 },
  ...{ solver: 'hinge-shell', tune: 'vertex', engine: 'stretch=200', bendRatio: 0.1, massRule: 'vertex' },
  ...{ scenario: 'wind', material: 'springs', seconds: 1, substeps: 9, converge: true, damping: 1 },
  ...{ selfCollision: true, colliders: 'ground:0', friction: 0.1, calibrate: false, weld: 4 },
  ...{
    mesh: 'a*',
    materialName: '?',
    exclude: 'b',
    dropExtensions: 'c',
    threads: 1,
    targetFaces: 12,
    fewestFaces: 12,
    fields: false,
  },
  ...{ perBody: true, levelFaces: [20], format: 'ply', compress: 'none', lodStyle: 'msft' },
};

/** Settings that request everything that a method can do. */
const everything = (method: Settings['method']): RunSettings => ({
  ...defaultSettings(method),
  ...{ modeCount: 4, modes: [1, 2], lods: [0.5], calibrate: true, maxFrequencyError: 90 },
  ...{
    fit: 'modal',
    curvatureWeight: 1,
    targetFaces: 14,
    fewestFaces: 10,
    levelFaces: [12],
    fields: true,
    solver: 'dihedral',
  },
});

let core: Core;
let model: OpenModel;
beforeAll(async () => {
  core = await loadTestCore(1);
  const document = startDocument();
  const primitive = primitiveOf(document, mesh);
  const vertices = Array.from({ length: vertexCount(mesh) }, (_, v) => v);
  const keep = vertices.map((v) => (v % 4) / 4);
  primitive.setAttribute('_KEEP', floats(document, 'SCALAR', keep));
  const uv = vertices.flatMap((v) => [mesh.positions[3 * v], mesh.positions[3 * v + 1]]);
  primitive.setAttribute('TEXCOORD_0', floats(document, 'VEC2', uv));
  addMesh(document, 'thing', [primitive]);
  model = await openModel([await glbFile(document)]);
});

function startRun(): { run: BodyRun; ran: Set<string> } {
  const ran = new Set<string>();
  const { document, bodies } = model;
  return { run: new BodyRun({ core, body: bodies[0], document }, (name) => ran.add(name)), ran };
}

const valuesOf = (run: BodyRun, settings: RunSettings) =>
  Object.fromEntries(NAMES.map((name) => [name, run.get(STAGES[name] as AnyStage, settings)]));

/** Whether a stage is in `from`, or needs one of `from` directly or indirectly under these settings. */
function follows(stage: AnyStage, from: Set<AnyStage>, settings: RunSettings): boolean {
  if (from.has(stage)) return true;
  return stage.isWanted(settings) && Object.values(stage.needs).some((need) => follows(need, from, settings));
}

/** The stages that run again after `setting` has changed, derived from READERS. */
function expectedToRun(setting: RunSettingName, method: Settings['method'], changed: RunSettings): string[] {
  if (WITHOUT_EFFECT[method].includes(setting) && setting !== 'seams') return [];
  const readers = READERS[setting].filter((name) => method === 'limber' || isReadBy(method, setting, name));
  const from = new Set<AnyStage>(readers.map((name) => STAGES[name]));
  return NAMES.filter((name) => STAGES[name].isWanted(changed) && follows(STAGES[name], from, changed))
    .map((name) => STAGES[name].name)
    .sort();
}

/** Whether `reader` reads the setting for a method other than limber: these are not fitted, and paper ignores seams. */
function isReadBy(method: Settings['method'], setting: RunSettingName, reader: StageName): boolean {
  if (setting === 'seams') return method === 'qem' && ['history', 'explanation'].includes(reader);
  const isOfFit = ['poisson', 'thickness', 'maxDeviation', 'minAngle', 'fit'].includes(setting);
  if (['furtherLevels', 'deviationMarks'].includes(reader) && isOfFit) return false;
  return !(reader === 'fitted' && setting === 'fit');
}

describe('a run over a body', () => {
  it('has a stage that reads each setting, or lists it as read by none', () => {
    const read = new Set(NAMES.flatMap((name) => STAGES[name].reads as readonly RunSettingName[]));
    const all = [
      ...(Object.keys(OPTIONS) as RunSettingName[]),
      'targetFaces',
      'fewestFaces',
      'levelFaces',
      'fields',
    ] as RunSettingName[];
    expect(Object.keys(READERS).sort()).toEqual([...all].sort());
    for (const setting of all)
      expect([setting, read.has(setting)]).toEqual([setting, READERS[setting].length > 0]);
    for (const setting of all) expect(OTHER[setting]).not.toEqual(everything('limber')[setting]);
  });

  it.each(['limber', 'paper', 'qem'] as const)(
    'with %s runs again exactly the stages that a changed setting affects, with the result of a fresh run',
    (method) => {
      const base = everything(method);
      const { run, ran } = startRun();
      valuesOf(run, base);
      const visible = new Set(NAMES.map((name) => STAGES[name].name));
      for (const setting of Object.keys(READERS) as RunSettingName[]) {
        if (setting === 'method' && method !== 'limber') continue;
        const changed = { ...base, [setting]: OTHER[setting] };
        ran.clear();
        const values = valuesOf(run, changed);
        const seen = [...ran].filter((name) => visible.has(name)).sort();
        expect([setting, seen]).toEqual([setting, expectedToRun(setting, method, changed)]);
        if (ran.size > 0) expect(values).toEqual(valuesOf(startRun().run, changed));
        valuesOf(run, base);
      }
    },
    600_000,
  );

  it('returns the same objects as before while nothing changes', () => {
    const { run, ran } = startRun();
    const settings = everything('limber');
    const first = valuesOf(run, settings);
    ran.clear();
    const again = valuesOf(run, structuredClone(settings));
    expect(ran.size).toBe(0);
    for (const name of NAMES) expect(again[name]).toBe(first[name]);
  });

  it('keeps the last value of a stage that fails, and the time it took', () => {
    const { run, ran } = startRun();
    const settings = everything('qem');
    const history = run.get(STAGES.history, settings);
    const seconds = run.secondsOf(STAGES.history, settings);
    expect(seconds).toBeGreaterThan(0);
    expect(() => run.get(STAGES.history, { ...settings, pins: 'vertices:999' })).toThrow(
      /^“Held in place” names vertex 999/,
    );
    ran.clear();
    expect(run.get(STAGES.history, settings)).toBe(history);
    expect(ran.size).toBe(0);
    expect(run.secondsOf(STAGES.history, { ...settings, creases: 3 })).toBe(0);
  });

  it('releases a handle of the core as soon as another value replaces it', () => {
    const released: number[] = [];
    const counting: Core = {
      ...core,
      releaseHistory: (handle) => {
        released.push(handle.handle);
        return core.releaseHistory(handle);
      },
    };
    const { document, bodies } = model;
    const run = new BodyRun({ core: counting, body: bodies[0], document });
    const settings = everything('qem');
    run.get(STAGES.level, settings);
    run.get(STAGES.level, { ...settings, targetFaces: 12 });
    expect(released).toHaveLength(0);
    run.get(STAGES.level, { ...settings, creases: 3 });
    expect(released).toHaveLength(1);
    run.dispose();
    expect(new Set(released).size).toBe(2);
  });

  it('recomputes values that were made from a released handle', () => {
    const { run } = startRun();
    const settings = everything('limber');
    const deviation = run.get(fittedDeviationsStage, settings)(14);
    expect(deviation).toBeGreaterThan(0);
    run.get(STAGES.level, { ...settings, sizeWeight: 0.1 });
    const again = run.get(fittedDeviationsStage, settings);
    expect(again(14)).toBe(deviation);
    expect(again(12)).toBeGreaterThan(0);
    run.dispose();
  });

  it('treats a model that is named and one that follows from `auto` as the same', () => {
    const paper = everything('paper');
    expect(keyOf(STAGES.modes, { ...paper, model: 'laplacian' })).toBe(keyOf(STAGES.modes, paper));
    expect(keyOf(STAGES.modes, { ...paper, model: 'shell' })).not.toBe(keyOf(STAGES.modes, paper));
    const limber = everything('limber');
    const asked = { ...limber, modes: 'auto' as const };
    expect(keyOf(STAGES.guidance, { ...limber, modes: [1, 2, 3, 4] })).toBe(keyOf(STAGES.guidance, asked));
  });

  it('does not depend on the modes with qem', () => {
    const qem = { ...everything('qem'), maxFrequencyError: 0 };
    for (const change of [{ modeCount: 7 }, { young: 5e6 }, { p: Infinity }, { thickness: 9 }, { unit: 3 }])
      expect(keyOf(STAGES.fitted, { ...qem, ...change })).toBe(keyOf(STAGES.fitted, qem));
  });

  it('depends on settings of the fit only with limber and with the fit on', () => {
    const [limber, paper] = [everything('limber'), everything('paper')].map((settings) => ({
      ...settings,
      maxFrequencyError: 0,
    }));
    const isSame = (settings: RunSettings, change: Partial<RunSettings>) =>
      keyOf(STAGES.furtherLevels, settings) === keyOf(STAGES.furtherLevels, { ...settings, ...change });
    expect(isSame(limber, { fit: 'off' })).toBe(false);
    expect(isSame(paper, { fit: 'off' })).toBe(true);
  });

  it('depends on the shell only with a fit to the modes', () => {
    const [modal, surface] = (['modal', 'surface'] as const).map((fit) => ({
      ...everything('limber'),
      fit,
    }));
    const another = { thickness: 7, poisson: 0.1 };
    expect(fitSettings({ ...modal, ...another })).not.toEqual(fitSettings(modal));
    expect(fitSettings({ ...surface, ...another })).toEqual(fitSettings(surface));
  });

  it('lets no stage see a setting that it does not declare', () => {
    const seen: object[] = [];
    const stage = declareStage({
      name: 'one',
      reads: ['weld'],
      needs: {},
      // @ts-expect-error: young is not declared
      run: (_context, _inputs, settings) => seen.push(settings, settings.young),
    });
    const { run } = startRun();
    run.get(stage, everything('limber'));
    expect(seen).toEqual([{ weld: 0 }, undefined]);
    // @ts-expect-error: the stage reads targetFaces, which is missing
    const key = keyOf(STAGES.level, defaultSettings());
    expect(key).not.toBe(keyOf(STAGES.level, everything('limber')));
  });
});

describe('the page and the command line', () => {
  it('write the same bytes from the same settings', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'limber-run-'));
    try {
      const [input, output] = [join(folder, 'two.obj'), join(folder, 'out.glb')];
      const text = twoBodies();
      writeFileSync(input, text);
      const flags = [
        '--faces',
        '300',
        '--max-deviation',
        '0',
        '--lods',
        '.5,.2',
        '--calibrate',
        '--fields',
        '--solver',
        'hinge-shell',
        '--threads',
        '1',
        '--quiet',
      ];
      const files = ['--bind', join(folder, 'bind.json'), '--settings', join(folder, 'settings.json')];
      const words = ['optimize', input, output, ...flags, ...files];
      const args = parseArguments([...words, '--report', join(folder, 'report.json')]) as Arguments;
      expect(await runOptimize(args)).toBe(0);

      const file = new FileRun(core, await openModel([textFile('two.obj', text)]));
      const { settings, fields, faces, ratio } = args;
      const request = requestFile(file, { settings, fields, faces, ratio });
      const page = await exportAll(file, request, { fields, binding: true, output: 'out.glb' });

      const written = (name: string) => new Uint8Array(readFileSync(join(folder, name)));
      expect(page.bytes).toEqual(written('out.glb'));
      expect(page.levels.map(({ bytes }) => bytes)).toEqual([
        written('out_lod1.glb'),
        written('out_lod2.glb'),
      ]);
      expect(page.binding).toBe(readFileSync(join(folder, 'bind.json'), 'utf8'));
      expect(page.settings).toBe(readFileSync(join(folder, 'settings.json'), 'utf8'));
      const report = JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8')) as typeof page.report;
      for (const key of [
        'input',
        'output',
        'modes',
        'fit',
        'fidelity',
        'surface',
        'stop',
        'calibration',
      ] as const)
        expect(page.report[key]).toEqual(report[key]);
      expect(page.report.calibration).toHaveLength(2);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  });
});

/** A torus and a sheet, each an object of an OBJ file. */
function twoBodies(): string {
  const lines = toObj(together(torus(16, 10), grid(6, 6))).split('\n');
  const firstOfGrid = lines.filter((line) => line.startsWith('v')).length + 2 * 16 * 10;
  lines.splice(firstOfGrid, 0, 'o sheet');
  return `o ring\n${lines.join('\n')}`;
}
