// Compares one result with its original; returns one flat record of numbers.

/** Number of compared modes; compareFidelity adds modes 11 to 20 itself. */
const MODE_COUNT = 10;

/**
 * Lengths in % of the original's diagonal, angles in degrees, errors in %. If the shell modes of a result cannot be
 * computed, `failure`, one sentence, replaces its frequencies.
 */
export function measure({ engine, core }, prepared, mesh) {
  const { weld, quality, distance, certificate } = engine.measureResult(core, prepared, { mesh });
  const { inspection } = weld;
  return {
    faces: mesh.triangles.length / 3,
    hausdorff: distance.hausdorff,
    meanDistance: distance.mean,
    minAngle: quality.minAngle,
    meanMinAngle: quality.meanMinAngle,
    topologyKept: certificate.kept && inspection.nonManifoldEdges + inspection.nonManifoldVertices === 0,
    ...fidelityOf({ engine, core }, prepared, weld.mesh),
  };
}

function fidelityOf({ engine, core }, prepared, mesh) {
  const material = engine.materialOf(prepared, engine.defaultSettings());
  try {
    return core.compareFidelity(prepared.mesh, mesh, { modeCount: MODE_COUNT, ...material });
  } catch (error) {
    return { failure: error.message };
  }
}
