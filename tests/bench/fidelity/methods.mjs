// The compared methods as data: { name, isOurs, holdsPins, version, run(mesh, faces) -> { mesh, seconds } };
// results of equal name and version are equal. With `holdsPins`, run also takes pinned vertices of the mesh.

import { meshoptimizerPeers } from './meshoptimizer_peers.mjs';
import { pythonPeers } from './python_peers.mjs';

/** One of our methods: the engine's whole pipeline with the method's defaults and `changes`. */
function ours(loaded, name, changes) {
  const { engine, core } = loaded;
  const settings = { ...engine.defaultSettings(changes.method), ...changes };
  engine.checkSettings(settings);
  const run = ({ prepared }, targetFaces, pinned) => {
    const asked = { targetFaces, pinned };
    const { result, seconds } = engine.optimizeBody(core, prepared, settings, asked);
    return { mesh: result.mesh, seconds };
  };
  const version = `${loaded.version} ${JSON.stringify(settings)}`;
  return { name, isOurs: true, holdsPins: true, version, settings, run };
}

/** The default on the mesh with other numbers of vertices and triangles: how much of an error is chance. */
export function renumberedMethod(loaded, changes) {
  const { engine, core } = loaded;
  const method = ours(loaded, RENUMBERED, { ...changes, method: 'limber', fit: 'surface' });
  const run = ({ prepared }, targetFaces) => {
    const other = engine.prepareBody(core, renumbered(prepared.body), method.settings);
    const { result, seconds } = engine.optimizeBody(core, other, method.settings, { targetFaces });
    return { mesh: result.mesh, seconds };
  };
  return { ...method, version: `${method.version} renumbered`, holdsPins: false, run };
}

const RENUMBERED = 'limber, surface fit, renumbered';

/** Vertices and triangles in a random order, which is always the same. */
function renumbered(body) {
  const numbers = shuffled(body.positions.length / 3);
  const positions = new Float32Array(body.positions.length);
  numbers.forEach((to, v) => positions.set(body.positions.subarray(3 * v, 3 * v + 3), 3 * to));
  const indices = new Uint32Array(body.indices.length);
  shuffled(indices.length / 3).forEach((to, t) => {
    for (let c = 0; c < 3; ++c) indices[3 * to + c] = numbers[body.indices[3 * t + c]];
  });
  return { ...body, positions, indices };
}

/** The numbers below `count` in a random order (Fisher and Yates), from the linear congruential generator of Numerical Recipes. */
function shuffled(count) {
  const order = Array.from({ length: count }, (_, i) => i);
  let state = 1;
  for (let i = count - 1; i > 0; --i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const j = Math.floor((state / 2 ** 32) * (i + 1));
    [order[i], order[j]] = [order[j], order[i]];
  }
  return order;
}

/** The settings for limber's own shell: the fit to its modes, from triangles that are more even than the default's. */
const FOR_THE_SHELL = { fit: 'modal', sizeWeight: 0.01 };

/** Our methods in this build of the engine, each with `changes`. The evaluation is in limber's own shell: so is the fit. */
export function ourMethods(loaded, changes = {}) {
  const { choices } = loaded.engine.OPTIONS.method;
  return choices.flatMap((method) => {
    if (method !== 'limber' || 'fit' in changes) return [ours(loaded, method, { ...changes, method })];
    return [
      ours(loaded, method, { ...changes, ...FOR_THE_SHELL, method }),
      ours(loaded, 'limber, surface fit', { ...changes, method, fit: 'surface' }),
      ours(loaded, 'limber without fit', { ...changes, method, fit: 'off' }),
    ];
  });
}

/** The peers; those that are not installed are pushed to `missing`. */
export async function peerMethods(loaded, missing) {
  return [...(await meshoptimizerPeers(loaded)), ...pythonPeers(missing)];
}
