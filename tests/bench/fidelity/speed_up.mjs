// How much faster a simulation is with fewer faces.

/** Milliseconds for which the two are stepped, alternately. */
const TIME = 1500;

let oneThread = null;

/**
 * The shortest step of the original over that of the result, twisted as shells with 20 substeps, on one thread. Measured anew in
 * every run.
 */
export async function speedUp({ engine, wasmFolder }, { prepared }, result) {
  oneThread ??= await engine.loadCore({ threads: 1, wasmFolder });
  const core = oneThread;
  const settings = { ...engine.defaultSettings(), material: 'shell', scenario: 'twist', substeps: 20 };
  const options = engine.simulationOptions(prepared, settings, null);
  const runs = [prepared.mesh, result].map((mesh) => core.startSimulation(mesh, prepared.mesh, options));
  const least = [Infinity, Infinity];
  const end = performance.now() + TIME;
  while (performance.now() < end)
    runs.forEach((run, i) => {
      const start = performance.now();
      core.stepSimulations(Uint32Array.of(run));
      least[i] = Math.min(least[i], performance.now() - start);
    });
  for (const run of runs) core.endSimulation(run);
  return least[0] / least[1];
}
