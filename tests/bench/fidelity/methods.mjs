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
