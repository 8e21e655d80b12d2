/** Writes the page of all cases as Markdown. */

import { errorPercent, facesWithin, finestErrors } from './cases/case';
import type { CaseResult, Run } from './cases/case';

/** % */
const TRUSTED = 3;

const row = (cells: string[]) => `| ${cells.join(' | ')} |`;
const signed = (value: number) => `${value < 0 ? '-' : '+'}${Math.abs(value).toFixed(2)} %`;

function table({ quantities, runs, digits }: CaseResult): string {
  const measured = (run: Run) =>
    quantities.map(({ analytic }, k) => {
      const value = run.computed[k];
      if (!Number.isFinite(value)) return 'not found';
      return `${value.toFixed(digits)} (${signed(errorPercent(value, analytic))})`;
    });
  return [
    row(['mesh', 'cells', 'faces', ...quantities.map(({ name }) => name)]),
    row(['---', '---', '---:', ...quantities.map(() => '---:')]),
    row(['**analytic**', '', '', ...quantities.map(({ analytic }) => `**${analytic.toFixed(digits)}**`)]),
    ...runs.map((run) => row([run.kind, run.size, String(run.faces), ...measured(run)])),
  ].join('\n');
}

export const hasPlot = (result: CaseResult) =>
  result.runs.every(({ kind }) => kind !== 'shell' && kind !== 'solid');

const anchor = (title: string) =>
  title
    .toLowerCase()
    .replace(/[^a-z0-9 -]/g, '')
    .replaceAll(' ', '-');

const summary = (result: CaseResult) =>
  row([`[${result.title}](#${anchor(result.title)})`, finestErrors(result.runs, result.quantities)]);

function section(result: CaseResult): string {
  const parts = [
    `## ${result.title}`,
    `${result.setting} **Compared with:** ${result.reference} **Interpretation:** ${result.reading}`,
  ];
  if (hasPlot(result)) {
    const worst = finestErrors(result.runs, result.quantities);
    const within = facesWithin(TRUSTED, result.runs, result.quantities);
    parts.push(
      `**Accuracy:** the largest error of these frequencies is ${worst} on the finest mesh of each kind. It is less than ${TRUSTED} %: ${within}.`,
    );
    parts.push(`![Worst error over the faces: ${result.title}](images/validation/${result.id}.svg)`);
  }
  return [...parts, table(result)].join('\n\n');
}

const INTRODUCTION = `# Validation

Frequencies of bodies whose vibrations are known, computed in WebAssembly by the same core that all of Limber uses, and compared
with the known values: under refinement, on regular, irregular and graded meshes. Everything on this page is generated,
including the plots, by \`npm run validate\` (after \`npm run build\`). Reference values are formulas and
small solvers in \`scripts/validation/analytic/\`, themselves checked against published tables in
\`tests/engine/validation.test.ts\`.

**Meshes.** Regular: equal cells, each split along the same diagonal. Union jack: along alternating diagonals. Irregular: vertices
moved by up to a quarter of a cell, random diagonals. Graded: the longest cell is about eight times as long as the shortest.
All solves are exact (\`--exact\`), with Young's modulus and density 1.

**Two kinds of error.** A computed frequency differs from the real one because the _model_ is a theory and because the
_mesh_ is coarse. The shell is thin-shell theory: it neglects shear through the thickness, which for a plate with a thickness of a tenth of its
side accounts for 4 to 9 %, on any mesh. Its mesh error decreases with the square of the cell size; the element (Morley) is too
soft, so the computed value is nearly always too low, and higher modes, whose waves are shorter, have larger errors. The solid is
three-dimensional elasticity without any such theory, on a lattice of about 2,000 cells that does not depend on the mesh: finer
triangles only follow a curved surface better. Its error is that of the lattice, about 1 %, up to 3 % if a limb is three cells wide. The
last section shows both models on the same slab.`;

export function page(results: CaseResult[]): string {
  const overview = [row(['case', 'worst error on the finest meshes']), row(['---', '---:'])];
  return [
    INTRODUCTION,
    [...overview, ...results.filter(hasPlot).map(summary)].join('\n'),
    ...results.map(section),
    '',
  ].join('\n\n');
}
