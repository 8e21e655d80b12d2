// Errors of the frequencies of a coarse mesh in solvers that were not written here, with the original's numbers and with tuned ones.

import { cached } from './cache.mjs';
import { hashOf } from './load_engine.mjs';

/** The models of solvers, by the names that --solver takes; `shell` is Limber's own. */
export const SOLVERS = ['shell', 'hinge-shell', 'dihedral', 'springs'];

const NOTHING_PINNED = { pinned: new Uint32Array(), pinnedOriginal: new Uint32Array() };

/** `TunedFrequencies` of a result of a prepared body in one solver; null, after a message, where it has none there. */
export function frequenciesIn({ engine, core }, prepared, mesh, { solver, tune }) {
  const settings = { ...engine.defaultSettings(), solver, tune };
  const options = { ...engine.tuneSettings(settings), runsTrial: false };
  try {
    return engine.tuneMesh(core, prepared, { mesh, ...NOTHING_PINNED }, options).tuned.frequencies;
  } catch (error) {
    console.error(`${prepared.body.name}, ${solver}: ${error.message}`);
    return null;
  }
}

/** Per solver the errors of modes 1 to 10 in %, `untouched` and `tuned` by two factors, of one of `runCases`; null without modes. */
export function solverErrors(loaded, { mesh, method, ratio, meshOf }) {
  const key = hashOf(loaded.version, mesh.hash, method.name, method.version, String(ratio), 'solvers');
  const compute = () => {
    const result = meshOf();
    const errors = SOLVERS.map((solver) => {
      const found = frequenciesIn(loaded, mesh.prepared, result, { solver, tune: 'global' });
      return [solver, found && { untouched: found.errorUntouched, tuned: found.errorTuned }];
    });
    return { record: Object.fromEntries(errors) };
  };
  return cached(key, compute).record;
}
