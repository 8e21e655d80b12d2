// Simplifies every mesh by every method at every ratio and measures the results.

import { cached } from './cache.mjs';
import { hashOf } from './load_engine.mjs';
import { measure } from './measure.mjs';

/**
 * Peers are also measured again if the core or the engine has changed, because these do the measuring; their meshes are kept.
 * One result: { mesh, kind, inputMinAngle, method, isOurs, ratio, targetFaces, ...measure(), seconds, meshOf() }.
 */
export function runCases(loaded, { meshes, methods, ratios }, print = console.log) {
  const total = meshes.length * methods.length * ratios.length;
  const cases = [];
  for (const mesh of meshes)
    for (const ratio of ratios)
      for (const method of methods) {
        const { record, meshOf } = runCase(loaded, mesh, method, ratio);
        const { name, isOurs } = method;
        const targetFaces = ratio * mesh.faces;
        const inputMinAngle = mesh.prepared.quality.minAngle;
        const about = {
          mesh: mesh.name,
          kind: mesh.kind,
          inputMinAngle,
          method: name,
          isOurs,
          ratio,
          targetFaces,
        };
        cases.push({ ...about, ...record, meshOf });
        print(`${cases.length}/${total} ${lineOf(cases.at(-1))}`);
      }
  return cases;
}

function runCase(loaded, mesh, method, ratio) {
  const ofResult = [mesh.hash, method.name, method.version, String(ratio)];
  const made = cached(hashOf('result', ...ofResult), () => {
    const { mesh: result, seconds } = method.run(mesh, ratio * mesh.faces);
    return { record: { seconds }, mesh: result };
  });
  const measured = cached(hashOf(loaded.version, ...ofResult), () => ({
    record: measure(loaded, mesh.prepared, made.meshOf()),
  }));
  return { record: { ...measured.record, ...made.record }, meshOf: made.meshOf };
}

function lineOf({ mesh, method, ratio, faces, frequencyErrorMean, failure }) {
  const outcome = failure ?? `${frequencyErrorMean.toFixed(2)} %`;
  return `${mesh}, ${100 * ratio} %, ${method}: ${faces} faces, ${outcome}`;
}
