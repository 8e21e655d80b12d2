/** examples/scale with several workers, one of them killed. Needs Python packages that this repository does not install. */

import { spawnSync } from 'node:child_process';
import { expect, it } from 'vitest';

const python = process.env.LIMBER_PYTHON ?? 'python3';
const script = new URL('../bench/scale/run_scale.py', import.meta.url).pathname;
const modules = 'import ray, snakemake, boto3, moto, flask';
const isInstalled = spawnSync(python, ['-c', modules]).status === 0;

// LIMBER_PYTHON names a Python that has them: pip install snakemake "ray[default]" boto3 "moto[server]".
it.skipIf(!isInstalled)(
  'gives the results of an undisturbed batch where a worker of Snakemake or Ray is killed',
  { timeout: 600_000 },
  () => {
    const { status, stdout, stderr } = spawnSync(python, [script], { encoding: 'utf8' });
    expect([status, stdout + (status === 0 ? '' : stderr)]).toEqual([0, expect.stringContaining('equal')]);
  },
);
