// Peers from Python: pymeshlab and fast-simplification, installed into build/bench/python if they are missing, and the two methods of
// tests/bench/literature, which need SciPy.

import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeMesh } from '../bench_meshes.mjs';
import { root, scratch } from './load_engine.mjs';

const own = join(root, 'build', 'bench', 'python', 'bin', 'python');
const program = join(import.meta.dirname, 'peer.py');

const versionOf = (python, name) => {
  const code = `import numpy, ${name.replace('-', '_')}; from importlib.metadata import version; print(version("${name}"))`;
  const { status, stdout } = spawnSync(python, ['-c', code], { encoding: 'utf8' });
  return status === 0 ? stdout.trim().split('\n').at(-1) : null;
};

/** A Python with the package: $LIMBER_BENCH_PYTHON, our own or python3; installs it into our own if needed; or null. */
function findPython(name) {
  const candidates = [process.env.LIMBER_BENCH_PYTHON, own, 'python3'];
  const found = candidates.find((python) => python && versionOf(python, name));
  if (found) return found;
  if (!existsSync(own) && spawnSync('python3', ['-m', 'venv', join(own, '..', '..')]).status !== 0)
    return null;
  spawnSync(own, ['-m', 'pip', 'install', '--quiet', 'numpy', name], { stdio: 'ignore' });
  return versionOf(own, name) ? own : null;
}

/** Reads a mesh that tests/bench/bench_meshes.mjs has written; each array has its own buffer. */
export function readMesh(path) {
  const { buffer, byteOffset, length } = readFileSync(path);
  const bytes = buffer.slice(byteOffset, byteOffset + length);
  const [vertices, triangles] = new Uint32Array(bytes, 0, 2);
  return {
    positions: new Float32Array(bytes, 8, 3 * vertices).slice(),
    triangles: new Uint32Array(bytes, 8 + 12 * vertices, 3 * triangles).slice(),
  };
}

function runPeer(python, name, { prepared }, faces) {
  mkdirSync(scratch, { recursive: true });
  const [source, target] = ['source.bin', 'result.bin'].map((file) => join(scratch, file));
  writeMesh(source, prepared.mesh);
  const output = execFileSync(python, [program, name, source, String(Math.floor(faces)), target], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const { seconds } = JSON.parse(output.trim().split('\n').at(-1));
  return { mesh: readMesh(target), seconds };
}

/** The source of a method of the literature as a hash, so that results follow its changes. */
function versionOfSource(name) {
  const folder = join(import.meta.dirname, '..', 'literature');
  const hash = createHash('sha256');
  for (const file of [name, 'surface', 'laplacian']) hash.update(readFileSync(join(folder, `${file}.py`)));
  return hash.digest('hex').slice(0, 8);
}

/** Methods for the installed packages; the others are pushed to `missing`. */
export function pythonPeers(missing) {
  const peers = [
    ['pymeshlab', 'pymeshlab', 'quadric edge collapse, topology and boundary preserved'],
    ['fast-simplification', 'fast-simplification', 'defaults'],
    ['Lescoat 2020', 'scipy', `60 eigenvectors, ${versionOfSource('spectral')}`],
    ['Dunyach 2013', 'scipy', `six rounds, ${versionOfSource('remeshing')}`],
  ];
  return peers.flatMap(([name, needed, settings]) => {
    const python = findPython(needed);
    if (!python) {
      missing.push(`${name} (python3 -m pip install ${needed})`);
      return [];
    }
    const version = `${name}, ${needed} ${versionOf(python, needed)}, ${settings}`;
    return [{ name, version, run: (mesh, faces) => runPeer(python, name, mesh, faces) }];
  });
}
