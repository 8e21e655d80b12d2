// The two methods of the literature that the benchmarks compare with have tests of their own, in Python with SciPy.

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, test } from 'vitest';

const root = join(import.meta.dirname, '..', '..');
const folder = join(root, 'tests', 'bench', 'literature');
const candidates = [
  process.env.LIMBER_BENCH_PYTHON,
  join(root, 'build', 'bench', 'python', 'bin', 'python'),
  'python3',
];
const python = candidates.find(
  (program) => program && spawnSync(program, ['-c', 'import scipy.sparse.linalg']).status === 0,
);

test.skipIf(python === undefined)(
  'spectral simplification and remeshing do what their papers say',
  () => {
    const { status, stdout, stderr } = spawnSync(python!, ['test_literature.py'], {
      cwd: folder,
      encoding: 'utf8',
      env: { ...process.env, PYTHONDONTWRITEBYTECODE: '1' },
    });
    expect(stderr).toBe('');
    expect(status).toBe(0);
    expect(stdout.trim().split('\n')).toHaveLength(6);
  },
  240_000,
);
