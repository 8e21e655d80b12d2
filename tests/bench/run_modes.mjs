// Times the core on one mesh; runs in Node and in a browser's worker.

/** Reads the file that writeMesh of bench_meshes.mjs has written. */
export function meshOf(buffer) {
  const [vertices, faces] = new Uint32Array(buffer, 0, 2);
  return {
    positions: new Float32Array(buffer, 8, 3 * vertices),
    triangles: new Uint32Array(buffer, 8 + 12 * vertices, 3 * faces),
  };
}

function diagonalOf({ positions }) {
  const size = [0, 1, 2].map((c) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = c; i < positions.length; i += 3) {
      low = Math.min(low, positions[i]);
      high = Math.max(high, positions[i]);
    }
    return high - low;
  });
  return Math.hypot(...size);
}

/** Computes twelve modes `calls` times in the same core, because the first call still compiles. */
export function runModes(core, buffer, { model, exact, calls }) {
  const mesh = meshOf(buffer);
  const options = {
    model,
    direction: -1,
    pinned: new Uint32Array(0),
    exact,
    modeCount: 12,
    thickness: 0.02 * diagonalOf(mesh),
    young: 1e6,
    poisson: 0.3,
    density: 1000,
    unit: 1,
  };
  const seconds = [];
  let set;
  for (let call = 0; call < calls; call++) {
    const start = performance.now();
    set = core.findModes(mesh, options);
    seconds.push((performance.now() - start) / 1000);
  }
  const [component] = set.components;
  return {
    seconds,
    threads: core.threads,
    heapBytes: core.peakHeapBytes(),
    modes: set.modes.length,
    worstResidual: Math.max(...set.modes.map((mode) => mode.residual)),
    model: component.model,
    coarseVertices: component.coarseVertices,
  };
}
