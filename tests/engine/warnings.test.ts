import { describe, expect, it } from 'vitest';
import { describeBodies } from '../../web/app/worker/bodies';
import { canRedraw, progressLine, redrawn } from '../../web/cli/terminal';
import { warningLines } from '../../web/cli/warnings';
import type { BodyRun } from '../../web/engine/stages/body_run';
import { FileRun } from '../../web/engine/stages/file_run';
import { openModel } from '../../web/engine/document/open';
import { preparedWarnings, resultWarnings } from '../../web/engine/stages/file_warnings';
import type { RunSettings } from '../../web/engine/stages/stage';
import { STAGES } from '../../web/engine/stages/stages';
import { lineAlone, ofBody, ofSentence } from '../../web/engine/report/warnings';
import { defaultSettings } from '../../web/engine/settings/options';
import { loadTestCore } from './support/core';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { torus } from './support/shapes';

const many = (count: number, textOf: (i: number) => string) =>
  Array.from({ length: count }, (_, i) => ofBody(`part ${i}`, textOf(i)));

describe('warnings', () => {
  it('that are equal for a hundred bodies are one line', () => {
    expect(
      warningLines(
        many(100, () => '2 edges shared by more than two faces, locked'),
        false,
      ),
    ).toEqual(['each of 100 bodies: 2 edges shared by more than two faces, locked']);
  });

  it('that differ in numbers are one line with ranges', () => {
    const warnings = many(3, (i) => `${1000 + 500 * i} seam vertices welded at 2 places, off ${i + 0.5} %`);
    expect(warningLines(warnings, false)).toEqual([
      'each of 3 bodies: 1,000 to 2,000 seam vertices welded at 2 places, off 0.5 to 2.5 %',
    ]);
  });

  it('with different words stay separate, in their order', () => {
    const warnings = ['of the file', ...many(2, () => 'a'), ofBody('lamp', 'b'), 'of the file'];
    expect(warningLines(warnings, false)).toEqual(['of the file', '2 bodies: a', 'lamp: b', 'of the file']);
  });

  it('have a line each with --verbose', () => {
    expect(
      warningLines(
        many(3, () => 'a'),
        true,
      ),
    ).toEqual(['part 0: a', 'part 1: a', 'part 2: a']);
  });

  it('of the only body do not name it', () => {
    expect(warningLines([ofBody('ring', 'a', false)], false)).toEqual(['a']);
  });

  it('of bodies that cannot be used are one line, and the sentence where it is one body', () => {
    const sentence = (name: string, faces: number) =>
      `Body "${name}" has no usable face, ${faces} with a repeated vertex: repair it; it is left unchanged`;
    expect(warningLines([ofSentence(sentence('a "b"', 1))], false)).toEqual([sentence('a "b"', 1)]);
    expect(warningLines([ofSentence(sentence('a', 1)), ofSentence(sentence('b', 7))], false)).toEqual([
      'each of 2 bodies: no usable face, 1 to 7 with a repeated vertex: repair it; it is left unchanged',
    ]);
  });
});

it('say what a solver moves if a node scales its mesh non-uniformly, and nothing otherwise', async () => {
  const document = startDocument();
  for (const name of ['even', 'uneven']) addMesh(document, name, [primitiveOf(document, torus())]);
  document.getRoot().listNodes()[1].setScale([1, 1, 3]);
  const file = new FileRun(await loadTestCore(1), await openModel([await glbFile(document)]));
  const linesFor = (solver: 'none' | 'jolt') =>
    preparedWarnings(file, { ...defaultSettings(), solver })
      .map(lineAlone)
      .filter((line) => line.includes('modelling program'));
  expect(linesFor('none')).toEqual([]);
  expect(linesFor('jolt')).toEqual([
    'uneven: its node scales it non-uniformly, so mesh and masses for the solver get the mean scale and another shape than in the scene: apply that scale in the modelling program first',
  ]);
  file.dispose();
});

it('say that a solver moves one of the scales at which the scene shows a mesh', async () => {
  const document = startDocument();
  addMesh(document, 'once', [primitiveOf(document, torus())]);
  const mesh = addMesh(document, 'often', [primitiveOf(document, torus())]);
  const scene = document.getRoot().listScenes()[0];
  for (const scale of [1, 3, 0.5])
    scene.addChild(document.createNode().setMesh(mesh).setScale([scale, scale, scale]));
  const file = new FileRun(await loadTestCore(1), await openModel([await glbFile(document)]));
  const linesFor = (solver: 'none' | 'jolt') =>
    preparedWarnings(file, { ...defaultSettings(), solver })
      .map(lineAlone)
      .filter((line) => line.includes('scale'));
  expect(linesFor('none')).toEqual([]);
  expect(linesFor('jolt')).toEqual([
    'often: the scene shows it at scales from 0.5 to 3, but mesh, masses and settings for the solver are for 1 alone: give copies of another scale a mesh of their own',
  ]);
  expect(describeBodies(file).map((body) => body.isScaledDifferently)).toEqual([false, true]);
  file.dispose();
});

describe('the line of progress', () => {
  it('is drawn on terminals that can go back in a line, and on nothing else', () => {
    expect(canRedraw({ isTTY: true }, 'xterm-256color')).toBe(true);
    expect(canRedraw({ isTTY: true }, 'dumb')).toBe(false);
    expect(canRedraw({ isTTY: false }, 'xterm')).toBe(false);
    expect(canRedraw({}, 'xterm')).toBe(false);
  });

  it('has no escape sequence, and hides what was there', () => {
    expect(redrawn('ab', 5)).toBe('\rab   ');
    expect(redrawn('', 3)).toBe('\r   ');
  });

  it('stays one line on a narrow terminal, where the name gives way', () => {
    const progress = { phase: 'fitting', fraction: 0.5 } as const;
    expect(progressLine('chair', progress)).toBe('chair: fitting 50 %');
    expect(progressLine('a'.repeat(200), progress)).toBe(`${'a'.repeat(62)}...: fitting 50 %`);
    expect(progressLine('a'.repeat(200), progress, 30)).toHaveLength(29);
    expect(progressLine('chair', progress, 10)).toHaveLength(9);
  });
});

it('of parts whose modes failed reach the caller of the library, too', () => {
  const values = new Map<unknown, unknown>([
    [STAGES.constraints, { note: '' }],
    [STAGES.guidingModes, { components: [{ failure: 'No solution was found.' }] }],
    [STAGES.fitted, { large: 0 }],
  ]);
  const run = { context: { body: { name: 'lamp' } }, get: (stage: unknown) => values.get(stage) };
  expect(resultWarnings(run as unknown as BodyRun, {} as RunSettings).map(lineAlone)).toEqual([
    'lamp is reduced by shape and triangle quality alone, because its modes failed: No solution was found',
  ]);
});
