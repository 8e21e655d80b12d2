/** examples/scale with several workers, one of them killed. Needs Python packages that this repository does not install. */

import { spawnSync } from 'node:child_process';
import { expect, it } from 'vitest';

const python = process.env.LIMBER_PYTHON ?? 'python3';
const script = new URL('../bench/scale/run_scale.py', import.meta.url).pathname;
const modules = 'import ray, snakemake, boto3, moto, flask';
const isInstalled = spawnSync(python, ['-c', modules]).status === 0;

const hasPython = spawnSync(python, ['-c', '']).status === 0;
const examples = new URL('../../examples/scale', import.meta.url).pathname;
const limber = new URL('../../dist/cli/limber.mjs', import.meta.url).pathname;

/** What a task of Ray does, without Ray. */
const TASK = String.raw`
import sys, types
sys.modules["ray"] = types.SimpleNamespace(remote=lambda **_: lambda function: function)
sys.dont_write_bytecode = True
sys.path.insert(0, ${JSON.stringify(examples)})
from ray_batch import run_limber
obj = b"mtllib wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n"
data, sentence = run_limber([${JSON.stringify(process.execPath)}, ${JSON.stringify(limber)}], {"a.obj": obj}, "a.obj", [])
print(data is not None, sentence)
`;

it.skipIf(!hasPython)('names the library of materials that a task of Ray has not fetched', () => {
  const { stdout, stderr } = spawnSync(python, ['-c', TASK], { encoding: 'utf8' });
  expect([stdout, stderr]).toEqual([
    expect.stringMatching(/^True (.*\n)*limber: wood\.mtl is missing: /),
    '',
  ]);
});

// LIMBER_PYTHON names a Python that has them: pip install snakemake "ray[default]" boto3 "moto[server]".
it.skipIf(!isInstalled)(
  'gives the results of an undisturbed batch where a worker of Snakemake or Ray is killed',
  { timeout: 600_000 },
  () => {
    const { status, stdout, stderr } = spawnSync(python, [script], { encoding: 'utf8' });
    expect([status, stdout + (status === 0 ? '' : stderr)]).toEqual([0, expect.stringContaining('equal')]);
  },
);
