/** The settings file says what a tuning has found, and is read back as it was written. */

import { describe, expect, it } from 'vitest';
import { originalParameters } from '../../web/engine/report/original_parameters';
import { exportedSettings, settingsFile, writeSettings } from '../../web/engine/report/settings_file';
import type { SettingsFile } from '../../web/engine/report/settings_file';
import { readSettingsFile } from '../../web/engine/report/settings_reader';
import { describeTuning, solverReport } from '../../web/engine/report/solver_report';
import { defaultSettings } from '../../web/engine/settings/options';
import type { SolverName } from '../../web/engine/solvers/profiles';
import type { TunedBody } from '../../web/engine/solvers/tuned_body';
import { tunedBody, TUNED_SHEET } from './support/tuned_sheet';

const fileOf = (tuned: TunedBody): SettingsFile =>
  settingsFile(
    [{ name: 'sheet', level: 0, meshNumber: 0, renderVertices: [0, 1, 2, 2, 1, 3, -1], tuned }],
    defaultSettings(),
  );

describe('a settings file', () => {
  it.each(['shell', 'hinge-shell', 'dihedral', 'springs', 'jolt', 'mujoco', 'newton', 'blender'] as const)(
    'for %s is read as it was written',
    (solver) => {
      const file = fileOf(tunedBody(solver));
      const text = writeSettings(file);
      expect(readSettingsFile('sheet.json', text)).toEqual(JSON.parse(JSON.stringify(file)));
      expect(writeSettings(fileOf(tunedBody(solver)))).toBe(text);
    },
  );

  it('has what a solver of springs needs', () => {
    const { schema, solver, units, engine, bodies, motion } = fileOf(tunedBody('springs'));
    expect([schema, solver, units.length]).toEqual(['limber-settings/1', 'springs', 1]);
    const [body] = bodies;
    expect(body.mesh.triangles).toEqual([...TUNED_SHEET.triangles]);
    expect(body.mesh.positions.map(Math.fround)).toEqual([...TUNED_SHEET.positions]);
    expect(body.stretch.pairs).toEqual([0, 1, 1, 2, 0, 2, 2, 3, 1, 3]);
    expect(body.bend.pairs).toEqual([0, 3]);
    expect(body.mass).toEqual({ rule: 'area', original: 'area', perVertex: [1, 2, 2, 0.333333333] });
    expect(body.pins).toEqual([1, 3]);
    expect(body.stretch.constant).toBeCloseTo(1.25 * body.original.stretch, 5);
    expect(body.bend.constant).toBeCloseTo(0.5 * body.original.bend, 5);
    expect(engine).toMatchObject({ stretch: body.stretch.constant, bend: body.bend.constant });
    expect([body.damping, body.friction]).toEqual([0.5, 0.5]);
    expect(motion).toMatchObject({ kept: 'tuned' });
  });

  it('has hinges, both constants of a membrane, maps and factors where there are any', () => {
    const fields = { stretchField: Float64Array.of(1, 1.5, 1, 1), bendField: Float64Array.of(1, 1, 0.5, 1) };
    const [body] = fileOf(tunedBody('newton', fields)).bodies;
    expect(body.vertex).toEqual({ stretch: [1, 1.5, 1, 1], bend: [1, 1, 0.5, 1] });
    expect(body.stretch.triangles).toBe(true);
    expect(body.stretch.second! / body.stretch.constant).toBeCloseTo(0.6 / 0.7, 6);
    expect(body.bend.hinges).toEqual([1, 2, 0, 3]);
    const factors = { stretchFactors: Float64Array.of(2, 3), bendFactors: Float64Array.of(0.25) };
    const [own] = fileOf(tunedBody('newton', factors)).bodies;
    expect([own.stretch.factors, own.bend.factors]).toEqual([[2, 3], [0.25]]);
  });

  it('keeps lists of numbers in one line', () => {
    const text = writeSettings(fileOf(tunedBody('springs')));
    expect(text).toContain('"pairs": [0,1,1,2,0,2,2,3,1,3]');
    expect(text.split('\n').length).toBeLessThan(120);
  });
});

describe('a damaged settings file', () => {
  const damaged = (change: (body: SettingsFile['bodies'][number], file: SettingsFile) => void): string => {
    const file = structuredClone(fileOf(tunedBody('springs')));
    change(file.bodies[0], file);
    return writeSettings(file);
  };

  it.each([
    ['{', 'is not JSON'],
    [
      '{"schema": "limber-binding/1"}',
      'is no settings file, because its "schema" is not "limber-settings/1"',
    ],
    ['{"schema": "limber-settings/1", "bodies": []}', 'has no bodies'],
    [
      damaged((_, file) => (file.solver = 'havok' as SolverName)),
      'is for "havok", which is not one of shell, ',
    ],
    [
      damaged((body) => (body.mesh.triangles[2] = 9)),
      'has triangles that refer to vertices it does not have for "sheet"',
    ],
    [
      damaged((_, file) => Object.assign(file, { tune: 'face' })),
      'has a tuning that is not one of global, vertex, ',
    ],
    [damaged((_, file) => (file.units.length = 0)), 'has a unit that is not a length'],
    [damaged((_, file) => delete (file.material as { young?: number }).young), 'has a damaged material'],
    [damaged((_, file) => (file.given = ['compliance'])), 'has parameters that its solver does not have'],
    [
      damaged((body) => (body.meshNumber = 0.5)),
      'has a mesh number that is not a whole number from 0 for "sheet"',
    ],
    [damaged((body) => (body.unit = -1)), 'has a unit that is not a length for "sheet"'],
    [
      damaged((body) => Object.assign(body.original, { faces: '32' })),
      'has damaged parameters of the engine or of the original for "sheet"',
    ],
    [
      damaged((body) => body.mass.perVertex.pop()),
      'has masses that are not one number above 0 for each vertex for "sheet"',
    ],
    [
      damaged((body) => Object.assign(body.mass, { original: 'equal' })),
      'has a mass rule that is neither area nor vertex for "sheet"',
    ],
    [
      damaged((body) => (body.mass.perVertex[0] = 0)),
      'has masses that are not one number above 0 for each vertex for "sheet"',
    ],
    [damaged((body) => body.stretch.pairs!.pop()), 'has damaged stretching constraints for "sheet"'],
    [damaged((body) => (body.bend.factors = [1, 2])), 'has damaged bending constraints for "sheet"'],
    [damaged((body) => (body.pins = [4])), 'has pins that refer to vertices it does not have for "sheet"'],
    [
      damaged((body) => (body.renderVertices = [4])),
      'has render vertices that refer to vertices it does not have for "sheet"',
    ],
    [
      damaged((body) => delete (body as Partial<typeof body>).mass),
      'has no mesh, mass, stretch or bend for "sheet"',
    ],
  ])('is refused with one sentence: %#', (text, problem) => {
    expect(() => readSettingsFile('s.json', text)).toThrow(`s.json ${problem}`);
    expect(() => readSettingsFile('s.json', text)).toThrow(
      /: write it again with limber optimize --settings\.$/,
    );
  });
});

describe('parameters to tune the same model with again', () => {
  it('are the given ones, or without a list of these all that are equal in all bodies', () => {
    const { given, ...file } = fileOf(tunedBody('jolt'));
    expect(given).toEqual([]);
    const all = originalParameters(file);
    expect(Object.keys(all)).toEqual(Object.keys(file.engine));
    expect(all.compliance).toBe(file.original.compliance);
    const [body] = file.bodies;
    const smaller = { ...body, original: { ...body.original, compliance: body.original.compliance / 2 } };
    const others = Object.keys(all).filter((name) => name !== 'compliance');
    expect(Object.keys(originalParameters({ ...file, bodies: [body, smaller] }))).toEqual(others);
    const further = { ...smaller, level: 1 };
    expect(originalParameters({ ...file, bodies: [body, further] })).toEqual(all);
    const { compliance } = file.original;
    expect(originalParameters({ ...file, given: ['compliance'] })).toEqual({ compliance });
  });
});

describe('settings in a GLB', () => {
  it('are numbers in the extras, and masses and maps as attributes', () => {
    const fields = { stretchField: Float64Array.of(1, 1.5, 1, 1), bendField: Float64Array.of(1, 1, 0.5, 1) };
    const { extras, attributes } = exportedSettings(tunedBody('jolt', fields));
    const { engine, stretch } = extras as { engine: Record<string, number>; stretch: { constant: number } };
    expect(engine.compliance * stretch.constant).toBeCloseTo(1, 6);
    expect(JSON.stringify(extras)).not.toMatch(/\[/);
    expect(Object.keys(attributes)).toEqual(['_LIMBER_MASS', '_LIMBER_STRETCH', '_LIMBER_BEND']);
    expect([...attributes._LIMBER_MASS]).toEqual([1, 2, 2, Math.fround(1 / 3)]);
    expect(Object.keys(exportedSettings(tunedBody('jolt')).attributes)).toEqual(['_LIMBER_MASS']);
  });
});

describe('settings in a report', () => {
  it('are those of the body with the largest error', () => {
    const worse = { errorUntouched: 9, errorTuned: 6, errorUnseen: 7, errorOtherPins: 8 };
    const report = solverReport([tunedBody('springs'), tunedBody('springs', { frequencies: worse })]);
    expect(report.schema).toBe('limber-report/2');
    expect(report.fidelity.solvers.springs!.frequencies).toEqual(worse);
  });

  it('lack errors of modes that a body does not have, with a note', () => {
    const none = { errorUntouched: NaN, errorTuned: NaN, errorUnseen: NaN, errorOtherPins: NaN };
    const flat = tunedBody('springs', {
      frequencies: none,
      frequencyStatus: 'noResistance',
      motion: null,
    });
    expect(fileOf(flat)).not.toHaveProperty('motion');
    expect(writeSettings(fileOf(flat))).toContain('"frequencies": {}');
    const { springs } = solverReport([flat, tunedBody('springs')]).fidelity.solvers;
    expect(springs!.frequencies.errorTuned).toBe(5);
    expect(describeTuning('springs', solverReport([flat]).fidelity.solvers.springs!)[0]).toMatch(
      /^in Springs this shape bends without resistance/,
    );
    const needle = { ...TUNED_SHEET, positions: Float32Array.of(0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0) };
    const withNeedle = solverReport([{ ...flat, mesh: needle }]).fidelity.solvers.springs!;
    expect(withNeedle.frequencyStatus).toBe('noArea');
    expect(describeTuning('springs', withNeedle)[0]).toMatch(
      /^in Springs this shape has no modes because of triangles without area, so there are no frequencies to tune/,
    );
    const lost = tunedBody('springs', { ...flat.tuned, frequencyStatus: 'noConvergence' });
    expect(describeTuning('springs', solverReport([lost]).fidelity.solvers.springs!)[0]).toMatch(
      /^in Springs the modes of this shape do not converge/,
    );
  });

  it('are described in sentences', () => {
    const { solvers } = solverReport([tunedBody('springs')]).fidelity;
    expect(describeTuning('springs', solvers.springs!)).toEqual([
      "in Springs the first ten frequencies are off by 5.00 % tuned (7.00 % in modes that were not tuned), by 40.00 % with the original's numbers",
      "when it sways, it deviates from the original by 0.40 % of its size tuned, by 1.50 % with the original's stiffness and masses (noise 0.010 %)",
    ]);
    const { frequencies } = solvers.springs!;
    const motion = {
      scene: 'hang',
      untouched: 0.2,
      tuned: 0.3,
      noiseFloor: 0.01,
      kept: 'untouched' as const,
    };
    const [errors, told] = describeTuning('jolt', { frequencies, motion });
    expect(errors).toMatch(/by 40\.00 % with the original's numbers$/);
    expect(told).toMatch(/so the file keeps the original's stiffness and transfers its masses$/);
    expect(describeTuning('jolt', { frequencies })[1]).toBe('the motion itself was not tested');
  });

  it('say that frequencies alone have kept the stiffness, where no motion has decided', () => {
    const unmoved = tunedBody('springs', { kept: 'untouched', motion: null });
    const report = solverReport([unmoved]).fidelity.solvers.springs!;
    expect(report.kept).toBe('untouched');
    expect(describeTuning('springs', report).slice(1)).toEqual([
      "a tuned stiffness would take the frequencies farther away on average, so the file keeps the original's and transfers its masses",
      'the motion itself was not tested',
    ]);
    const moved = tunedBody('springs', { kept: 'untouched' });
    expect(solverReport([moved]).fidelity.solvers.springs!).not.toHaveProperty('kept');
  });

  it('name values that the engine does not accept, of all bodies the one farthest out of range', () => {
    const body = tunedBody('blender');
    const within = { ...body.original.values, tension: 9000 };
    const stiff = (tension: number) => ({
      ...body,
      original: { ...body.original, values: within },
      result: { ...body.result, values: { ...within, tension } },
    });
    expect(solverReport([stiff(9500)]).fidelity.solvers.blender).not.toHaveProperty('outOfRange');
    const { blender } = solverReport([stiff(11000), stiff(17320.5)]).fidelity.solvers;
    expect(blender!.outOfRange).toEqual([{ name: 'tension', value: 17320.5, min: 1e-9, max: 10000 }]);
    expect(describeTuning('blender', blender!).at(-1)).toBe(
      'Blender takes a tension of at most 10,000, and this needs 17,300: choose another material or thickness, or give your own numbers',
    );
  });

  it('names a damping with which Blender can blow up, of the body that is farthest beyond', () => {
    const body = tunedBody('blender');
    const values = { ...body.original.values, mass: 0.01, quality: 5, bending_damping: 0.02 };
    const damped = (bending_damping: number) => ({
      ...body,
      original: { ...body.original, values },
      result: { ...body.result, values: { ...values, bending_damping } },
    });
    expect(solverReport([damped(0.024)]).fidelity.solvers.blender).not.toHaveProperty('blowsUp');
    const { blender } = solverReport([damped(0.03), damped(0.5)]).fidelity.solvers;
    expect(blender!.blowsUp).toEqual({ name: 'bending_damping', value: 0.5, max: 0.025 });
    expect(describeTuning('blender', blender!).at(-1)).toBe(
      'Blender can blow up with a bending_damping of 0.5: keep it below 0.025, which is half of mass times quality',
    );
  });
});
