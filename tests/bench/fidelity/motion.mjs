// Measures how far the results of every method deviate from their originals in motion: --motion of evaluate.mjs.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { hashOf, scratch } from './load_engine.mjs';
import { samplePoints } from './motion_points.mjs';
import { meanOf } from './targets.mjs';
import { runCases } from './run_cases.mjs';

const RATIO = 0.25;
/** The pins of each motion in the syntax of --pins: the default pins of the scenario. */
export const MOTIONS = { sway: 'low:6', twist: 'low:6+high:6', drape: '' };
/**
 * Seconds and substeps of each motion. With fewer substeps the original is softer than its material by as much as results
 * differ, and a result that is too soft would come closest.
 */
export const [SECONDS, SUBSTEPS] = [1, 400];
/** The row that shows the error of the solver itself. */
export const SOLVER = 'the original, half the substeps';

/**
 * { mesh, method, sway, twist, drape } for every mesh and method: the mean deviation, or null if the motion diverged. A
 * method that accepts pins has a second row, `NAME, with pins`, with its results for each motion's pins.
 */
export function runMotions(loaded, { meshes, methods }) {
  mkdirSync(join(scratch, 'motion'), { recursive: true });
  return meshes.flatMap((mesh) => {
    const found = new Map();
    for (const [motion, pins] of Object.entries(MOTIONS)) {
      const pinned = loaded.engine.findPins(pins, null, mesh.prepared);
      const bodies = bodiesOf(loaded, mesh, methods, pinned);
      for (const [name, deviation] of deviations(loaded, mesh, { motion, pinned, bodies })) {
        found.set(name, { ...(found.get(name) ?? { mesh: mesh.name, method: name }), [motion]: deviation });
        console.log(`${mesh.name}, ${motion}, ${name}: ${deviation?.toFixed(3) ?? 'diverged'}`);
      }
    }
    return [...found.values()];
  });
}

/** [name, mesh, substeps] of all bodies except the original. Without pins there are no `told` rows. */
function bodiesOf(loaded, mesh, methods, pinned) {
  const told = methods.filter(({ holdsPins }) => holdsPins);
  const meshOf = (method) => {
    const [{ meshOf }] = runCases(loaded, { meshes: [mesh], methods: [method], ratios: [RATIO] }, () => {});
    return meshOf();
  };
  return [
    [SOLVER, mesh.prepared.mesh, SUBSTEPS / 2],
    ...methods.map((method) => [method.name, meshOf(method), SUBSTEPS]),
    ...told.map((method) => [
      `${method.name}, with pins`,
      meshOf(pinned.length === 0 ? method : toldOf(method, pinned)),
      SUBSTEPS,
    ]),
  ];
}

function toldOf(method, pinned) {
  const run = (mesh, faces) => method.run(mesh, faces, pinned);
  return {
    ...method,
    name: `${method.name}, with pins`,
    version: `${method.version} ${hashOf(pinned)}`,
    run,
  };
}

/** [name, mean deviation in % of the diagonal, or null] for every body. */
function deviations(loaded, mesh, { motion, pinned, bodies }) {
  const { engine, core, version } = loaded;
  const settings = { ...engine.defaultSettings(), scenario: motion, seconds: SECONDS };
  const options = engine.simulationOptions(mesh.prepared, settings, pinned);
  const original = mesh.prepared.mesh;
  let reference = null;
  const points = samplePoints(original);
  return bodies.map(([name, body, substeps]) => {
    const key = hashOf(
      version,
      mesh.hash,
      body.positions,
      body.triangles,
      `${motion} ${substeps} ${SECONDS}`,
    );
    const file = join(scratch, 'motion', `${key}.json`);
    if (existsSync(file)) return [name, JSON.parse(readFileSync(file, 'utf8'))];
    const run = (moving, steps) =>
      pathsOf({ engine, core }, original, { moving, points, options: { ...options, substeps: steps } });
    reference ??= run(original, SUBSTEPS);
    const paths = run(body, substeps);
    const mean = paths && (100 / mesh.prepared.diagonal) * meanDistance(reference, paths);
    writeFileSync(file, JSON.stringify(mean));
    return [name, mean];
  });
}

/** Displacements of points of the original's surface after each step, [(step * points + point) * 3 + c]. */
function pathsOf({ engine, core }, original, { moving, points, options }) {
  const placeOn = (point) => engine.positionOf(original.triangles, original.positions, point);
  const bound =
    moving === original
      ? points
      : points.map((point) => core.closestPoint(moving, new Uint32Array(), placeOn(point)));
  const rest = bound.map((point) => engine.positionOf(moving.triangles, moving.positions, point));
  const body = core.startSimulation(moving, original, options);
  const steps = Math.round(options.seconds / engine.STEP_SECONDS);
  const paths = new Float64Array(3 * steps * points.length);
  try {
    for (let step = 0; step < steps; ++step) {
      core.stepSimulations(Uint32Array.of(body));
      const positions = core.simulationPositions(body);
      bound.forEach((point, i) => {
        const place = engine.positionOf(moving.triangles, positions, point);
        for (let c = 0; c < 3; ++c) paths[3 * (step * points.length + i) + c] = place[c] - rest[i][c];
      });
    }
  } catch {
    return null;
  } finally {
    core.endSimulation(body);
  }
  return paths;
}

function meanDistance(a, b) {
  const distances = Array.from({ length: a.length / 3 }, (_, i) =>
    Math.hypot(a[3 * i] - b[3 * i], a[3 * i + 1] - b[3 * i + 1], a[3 * i + 2] - b[3 * i + 2]),
  );
  return meanOf(distances);
}
