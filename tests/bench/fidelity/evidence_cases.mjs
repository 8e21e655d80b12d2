// What the benches of docs/evidence.md share: the cases that they measure, and how means are taken over them.

import { loadEngine } from './load_engine.mjs';
import { loadMeshes } from './meshes.mjs';
import { ourMethods, peerMethods, renumberedMethod } from './methods.mjs';
import { runCases } from './run_cases.mjs';

export const EVIDENCE_MESHES = 'spot,torus,cloth grid,ribbon';

/** The cases of some meshes, by name, at some ratios, by the methods for which `isWanted(name)`; `missing` lists what is absent. */
export async function evidenceCases({ names, ratios, isWanted }) {
  const missing = [];
  const loaded = await loadEngine();
  const meshes = loadMeshes(loaded, { names, missing });
  // The guard that is on by default would stop before the smaller numbers of faces.
  const changes = { maxDeviation: 0 };
  const own = [...ourMethods(loaded, changes), renumberedMethod(loaded, changes)];
  const all = [...own, ...(await peerMethods(loaded, missing))];
  const methods = all.filter(({ name }) => isWanted(name));
  return { loaded, meshes, methods, missing, cases: runCases(loaded, { meshes, methods, ratios }) };
}

export const geometricMean = (values) =>
  Math.exp(values.reduce((sum, value) => sum + Math.log(Math.max(value, 1e-6)), 0) / values.length);

/** Whether a result has about as few faces as were asked for: 2 % more at most. */
export const reachesTarget = ({ faces, targetFaces }) => faces <= 1.02 * targetFaces + 2;

/** A number with two digits that count. */
export const twoDigits = (value) => String(Number(value.toPrecision(2)));
