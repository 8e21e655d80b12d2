import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { tableAsCsv, tableAsLatex, tableAsMarkdown } from '../../web/engine/report/tables/method_table';
import type { Table } from '../../web/engine/report/tables/method_table';
import { budgetTable } from '../../web/engine/stages/equal_budget/budget_table';
import {
  COMPARED_METHODS,
  resultAtBudget,
  settingsForMethod,
  withoutLimits,
} from '../../web/engine/stages/equal_budget/equal_budget';
import type { MethodResult } from '../../web/engine/stages/equal_budget/equal_budget';
import { meshoptimizerCall } from '../../web/engine/stages/equal_budget/meshoptimizer';
import { sizesOf } from '../../web/engine/stages/equal_budget/sizes';
import { STAGES } from '../../web/engine/stages/stages';
import { defaultSettings } from '../../web/engine/settings/options';
import { loadTestCore } from './support/core';
import { runOfMesh } from './support/runs';
import { torus } from './support/shapes';

const table: Table = {
  caption: '50% of "a_b" & c|d\nnext',
  columns: [
    { title: 'Method', digits: null },
    { title: 'Change, %', digits: 2 },
    { title: 'Angle, °', digits: 1 },
  ],
  rows: [
    ['=HYPERLINK("x")', -0.126, 3],
    ['a|b_c\\d{e}~^<f>$#', -0.0001, null],
    ['last, one', Number.NaN, 12.25],
  ],
};

describe('tables of methods', () => {
  it('writes CSV with numbers in full, quotes where needed, and no formula', () => {
    expect(tableAsCsv(table)).toBe(
      [
        'Method,"Change, %","Angle, °"',
        `"'=HYPERLINK(""x"")",-0.126,3`,
        'a|b_c\\d{e}~^<f>$#,-0.0001,',
        '"last, one",,12.25',
        '',
      ].join('\r\n'),
    );
  });

  it('writes Markdown whose cells cannot break the table', () => {
    expect(tableAsMarkdown(table)).toBe(
      [
        '50% of "a\\_b" & c\\|d next',
        '',
        '| Method | Change, % | Angle, ° |',
        '| --- | ---: | ---: |',
        '| =HYPERLINK("x") | -0.13 | 3.0 |',
        '| a\\|b\\_c\\\\d{e}\\~^\\<f\\>\\$\\# | 0.00 | – |',
        '| last, one | – | 12.3 |',
        '',
      ].join('\n'),
    );
  });

  it('writes LaTeX with every special letter escaped, for booktabs', () => {
    const text = tableAsLatex(table);
    expect(text).toContain("\\caption{50\\% of ''a\\_b'' \\& c\\textbar{}d next}");
    expect(text).toContain('\\begin{tabular}{lrr}');
    expect(text).toContain('Method & Change, \\% & Angle, $^\\circ$ \\\\');
    expect(text).toContain("=HYPERLINK(''x'') & $-$0.13 & 3.0 \\\\");
    expect(text).toContain(
      'a\\textbar{}b\\_c\\textbackslash{}d\\{e\\}\\textasciitilde{}\\textasciicircum{}\\textless{}f\\textgreater{}\\$\\# & 0.00 & -- \\\\',
    );
    for (const rule of ['toprule', 'midrule', 'bottomrule']) expect(text.split(`\\${rule}`)).toHaveLength(2);
  });

  it('has a column for each measure, and a row for each result', () => {
    const result: MethodResult = {
      ...{ name: 'qem', mesh: { positions: new Float32Array(), triangles: new Uint32Array() }, faces: 500 },
      ...{ hausdorff: 1.234, mean: 0.0456, frequencyErrorMean: 2.5, macMin: 0.98, minAngle: 9 },
      ...{ areaChange: -0.4, volumeChange: null, isTopologyKept: false, seconds: 0.125, failure: '' },
    };
    const made = budgetTable([result], { model: 'bar', faces: 500, originalFaces: 1000 });
    expect(made.caption).toContain('bar: methods at 500 of 1000 faces');
    expect(made.columns).toHaveLength(11);
    expect(tableAsCsv(made).split('\r\n')[1]).toBe('QEM,500,0.0456,1.234,2.5,0.98,9,-0.4,,changed,0.125');
  });
});

/** A cube of side 2 away from the origin, each side cut into n x n squares. */
function cube(n: number) {
  const ids = new Map<string, number>();
  const positions: number[] = [];
  const triangles: number[] = [];
  const vertex = (point: number[]): number => {
    const key = point.join(' ');
    if (!ids.has(key)) {
      ids.set(key, ids.size);
      positions.push(...point.map((value) => 5 + (2 * value) / n));
    }
    return ids.get(key)!;
  };
  for (const axis of [0, 1, 2])
    for (const side of [0, n])
      for (let i = 0; i < n; i++)
        for (let j = 0; j < n; j++) {
          const corner = (a: number, b: number): number => {
            const point = [0, 0, 0];
            point[axis] = side;
            point[(axis + 1) % 3] = a;
            point[(axis + 2) % 3] = b;
            return vertex(point);
          };
          const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
          triangles.push(...(side > 0 ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
        }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

const verticesOf = ({ positions }: { positions: Float32Array }): string[] =>
  Array.from({ length: positions.length / 3 }, (_, v) => positions.subarray(3 * v, 3 * v + 3).join(' '));

describe('methods at an equal budget', () => {
  it('computes area and volume of a cube', () => {
    const { area, volume } = sizesOf(cube(4));
    expect(area).toBeCloseTo(24, 5);
    expect(volume).toBeCloseTo(8, 5);
  });

  it('lets meshoptimizer simplify a cube to its twelve faces, exactly', async () => {
    const original = cube(6);
    for (const call of ['simplify', 'update'] as const) {
      const before = original.triangles.slice();
      const run = await meshoptimizerCall(call);
      const mesh = run(original, 12);
      expect(mesh.triangles).toHaveLength(36);
      expect(mesh.positions).toHaveLength(24);
      expect(Math.max(...mesh.triangles)).toBe(7);
      const kept = verticesOf(mesh).filter((vertex) => verticesOf(original).includes(vertex));
      // Only the second call moves vertices; its regularisation rounds the corners of so few faces.
      if (call === 'simplify')
        expect([kept.length, Math.round(1e9 * sizesOf(mesh).volume)]).toEqual([8, 8e9]);
      else expect(kept.length).toBeLessThan(8);
      expect(original.triangles).toEqual(before);
    }
  });

  it('lifts the limits that would stop a method, and keeps the weights of the chosen one', () => {
    const settings = { ...defaultSettings(), strainWeight: 7, maxDeviation: 2, minAngle: 5 };
    const own = withoutLimits(settingsForMethod(settings, 'limber'));
    expect(own).toMatchObject({ strainWeight: 7, maxDeviation: 0, minAngle: 0, maxFrequencyError: 0 });
    expect(settingsForMethod(settings, 'limber')).toBe(settings);
    expect(settingsForMethod(settings, 'paper')).toMatchObject({ method: 'paper', strainWeight: 0.05 });
    expect(COMPARED_METHODS).toHaveLength(5);
  });
});

describe('a method at a budget', () => {
  let core: Core;
  beforeAll(async () => {
    core = await loadTestCore(1);
  });

  it('is measured like the result of the page, whose own values stay unchanged', async () => {
    const run = runOfMesh(core, torus(24, 16));
    const settings = { ...defaultSettings(), maxDeviation: 0 };
    const faces = 300;
    const shown = { ...settings, targetFaces: faces };
    const fitted = run.get(STAGES.fitted, shown);
    const { distance, quality } = run.get(STAGES.measured, shown);
    const limber = await resultAtBudget(run, settings, { name: 'limber', faces });
    expect(limber.mesh).toEqual(fitted.result.mesh);
    expect([limber.hausdorff, limber.mean, limber.minAngle]).toEqual([
      distance.hausdorff,
      distance.mean,
      quality.minAngle,
    ]);
    const peer = await resultAtBudget(run, settings, { name: 'meshoptimizer simplify', faces });
    expect(peer.faces).toBeLessThanOrEqual(faces);
    expect(peer.frequencyErrorMean).toBeGreaterThan(limber.frequencyErrorMean!);
    expect(run.get(STAGES.fitted, shown)).toBe(fitted);
  });

  it('reaches the budget although a limit would stop it before', async () => {
    const run = runOfMesh(core, torus(24, 16));
    const settings = { ...defaultSettings(), maxDeviation: 0.05 };
    expect(
      run.get(STAGES.fitted, { ...settings, targetFaces: 100 }).result.mesh.triangles.length,
    ).toBeGreaterThan(300);
    expect((await resultAtBudget(run, settings, { name: 'limber', faces: 100 })).faces).toBeLessThanOrEqual(
      100,
    );
  });
});
