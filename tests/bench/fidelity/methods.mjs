// The methods that are compared, as data: { name, isOurs, run(mesh, faces) -> { mesh, seconds } }.

/** A method of ours: the engine's whole pipeline with the defaults of the method and `changes`. */
function ours({ engine, core }, name, changes) {
  const settings = { ...engine.defaultSettings(), ...changes };
  engine.checkSettings(settings);
  const run = ({ prepared }, targetFaces) => {
    const started = performance.now();
    const { result, timings } = engine.optimizeBody(core, prepared, settings, { targetFaces });
    return { mesh: result.mesh, seconds: (performance.now() - started) / 1000 - timings.measure };
  };
  return { name, isOurs: true, settings, run };
}

/** Ours that this build of the engine knows; `changes` go to each of them. */
export function ourMethods(loaded, changes = {}) {
  const { choices } = loaded.engine.OPTIONS.method;
  const knowsFit = 'fit' in loaded.engine.OPTIONS;
  return choices.flatMap((method) => {
    const plain = ours(loaded, method, { ...changes, method });
    if (method !== 'limber' || !knowsFit || 'fit' in changes) return [plain];
    return [plain, ours(loaded, 'limber, no fit', { ...changes, method, fit: false })];
  });
}
