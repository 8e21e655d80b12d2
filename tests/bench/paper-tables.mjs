// Reproduces the paper's Tables 2 to 5 by the command line; prints both as Markdown for docs/paper.md.
// Usage: npm run build && node tests/bench/paper-tables.mjs > tables.md
// The bar, the cloth and the tower are the project's own samples; other meshes are read from ../shared/meshes (or the
// folder in LIMBER_SHARED) and their rows say so if they are absent.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const root = resolve(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const folder = mkdtempSync(join(tmpdir(), 'limber-tables-'));
const sample = (name) => join(root, 'public', 'samples', `${name}.glb`);
const real = (name) => join(shared, name);

/** Runs `limber optimize` and returns its report; a missed target (exit 2) also has one. */
function optimize(input, options) {
  const report = join(folder, 'report.json');
  const args = [
    join(root, 'dist', 'cli', 'limber.mjs'),
    'optimize',
    input,
    join(folder, 'out.glb'),
    ...options,
    '--quiet',
  ];
  try {
    execFileSync(process.execPath, [...args, '--report', report], { stdio: ['ignore', 'ignore', 'inherit'] });
  } catch (error) {
    if (error.status !== 2) throw error;
  }
  return JSON.parse(readFileSync(report, 'utf8'));
}

const weights = (strain, curvature, quality) => [
  '--strain-weight',
  String(strain),
  '--curvature-weight',
  String(curvature),
  '--quality-weight',
  String(quality),
];
const fixed = (value, digits) => (value === undefined || value === null ? 'n/a' : value.toFixed(digits));
const row = (...cells) => `| ${cells.join(' | ')} |`;
const header = (...cells) => `${row(...cells)}\n${row(...cells.map(() => '---'))}`;

/** A report's lengths are in % of the diagonal; the paper's are in units of its model. */
const inUnits = (percent, diagonal) => (percent * diagonal) / 100;

function table3() {
  const diagonal = Math.hypot(1, 1, 3);
  const rows = [
    ['QEM only', ['--method', 'qem'], '0.125', '0.00', '37.39'],
    ['+ curvature', ['--method', 'paper', ...weights(0, 1, 0)], '0.125', '0.00', '25.04'],
    ['+ triangle quality', ['--method', 'paper', ...weights(0, 1, 0.01)], '0.088', '26.57', '44.53'],
    ['+ strain (full)', ['--method', 'paper', ...weights(0.05, 1, 0.01)], '0.088', '21.80', '44.22'],
  ];
  console.log('\n### Table 3: the bar at 950 faces, terms added one by one\n');
  console.log(
    header(
      'cost',
      'vertex Hausdorff, paper',
      'ours',
      'surface Hausdorff, ours',
      'min angle, paper',
      'ours',
      'mean min angle, paper',
      'ours',
      'vertices',
    ),
  );
  for (const [name, options, hausdorff, angle, meanAngle] of rows) {
    const { surface, output } = optimize(sample('bar'), ['--faces', '950', ...options]);
    const vertexDistance = fixed(inUnits(surface.vertexHausdorff, diagonal), 3);
    const surfaceDistance = fixed(inUnits(surface.hausdorff, diagonal), 4);
    const angles = [angle, fixed(output.minAngle, 2), meanAngle, fixed(output.meanMinAngle, 2)];
    console.log(row(name, hausdorff, vertexDistance, surfaceDistance, ...angles, output.vertices));
  }
}

function table2() {
  console.log('\n### Table 2: face and vertex counts\n');
  console.log(
    header('model', 'faces, original', 'faces, paper', 'ours', 'vertices, paper', 'ours', 'topology kept'),
  );
  const rows = [
    ['Rectangle', sample('bar'), 950, 474],
    ['Eiffel', real('derived_eiffel_6156.obj'), 3832, 1910],
    ['our tower', sample('tower'), 3832, 'n/a'],
  ];
  for (const [name, input, faces, vertices] of rows) {
    if (!existsSync(input)) {
      console.log(row(name, 'mesh absent', faces, '', vertices, '', ''));
      continue;
    }
    const { input: before, output: after } = optimize(input, ['--method', 'paper', '--faces', String(faces)]);
    const kept = ['components', 'boundaryLoops', 'genus'].every((key) => before[key] === after[key]);
    console.log(row(name, before.faces, faces, after.faces, vertices, after.vertices, kept ? 'yes' : 'NO'));
  }
}

function table4() {
  console.log('\n### Table 4: the hanging cloth (33 x 33 vertices) at half of its faces\n');
  console.log(
    header(
      'method',
      'min angle',
      'mean min angle',
      'Hausdorff, % of diagonal',
      'mean distance, %',
      'vertex Hausdorff, %',
    ),
  );
  console.log(row('paper: Dunyach et al. (file units)', '0.37', '39.86', '0.0735 (units)', '', ''));
  console.log(row('paper: theirs (file units)', '5.68', '42.27', '0.0675 (units)', '', ''));
  for (const method of ['qem', 'paper']) {
    const { surface, output } = optimize(sample('cloth'), ['--method', method, '--ratio', '0.5']);
    const distances = [surface.hausdorff, surface.mean, surface.vertexHausdorff].map((value) =>
      fixed(value, 4),
    );
    console.log(
      row(`ours: ${method}`, fixed(output.minAngle, 2), fixed(output.meanMinAngle, 2), ...distances),
    );
  }
}

function table5() {
  console.log('\n### Table 5: complex topology at 25 % of the faces\n');
  console.log(
    header(
      'model',
      'faces',
      'genus',
      'modes, s',
      'Hausdorff, % of diagonal',
      'min angle',
      'mean min angle',
      'topology kept',
    ),
  );
  console.log(
    row(
      'paper: Coral Cuffs',
      '9,998 -> 2,500',
      'n/a',
      '1.77',
      '0.088 (units)',
      '1.40 -> 0.42',
      '26.43 -> 28.76',
      'yes',
    ),
  );
  console.log(
    row(
      'paper: Ornaments',
      '5,000 -> 1,250',
      'n/a',
      '0.60',
      '0.078 (units)',
      '0.49 -> 1.27',
      '14.21 -> 15.50',
      'yes',
    ),
  );
  const meshes = [
    sample('organic'),
    sample('tower'),
    real('pyramid_frame_genus4.obj'),
    real('bob_genus1.obj'),
  ];
  for (const input of meshes) {
    const name = input.split('/').pop();
    if (!existsSync(input)) {
      console.log(row(name, 'mesh absent', '', '', '', '', '', ''));
      continue;
    }
    const {
      input: before,
      output: after,
      surface,
      timings,
    } = optimize(input, ['--method', 'paper', '--ratio', '0.25']);
    const kept = ['components', 'boundaryLoops', 'genus'].every((key) => before[key] === after[key]);
    const angles = [
      `${fixed(before.minAngle, 2)} -> ${fixed(after.minAngle, 2)}`,
      `${fixed(before.meanMinAngle, 2)} -> ${fixed(after.meanMinAngle, 2)}`,
    ];
    const faces = `${before.faces} -> ${after.faces}`;
    console.log(
      row(
        name,
        faces,
        before.genus,
        fixed(timings.modes, 2),
        fixed(surface.hausdorff, 3),
        ...angles,
        kept ? 'yes' : 'NO',
      ),
    );
  }
}

table2();
table3();
table4();
table5();
rmSync(folder, { recursive: true });
