/** The options of a simulation, from the settings, an original and its result. */

import { faceCount, vertexCount } from '../core/mesh';
import type { Binding, Core, SimulationModel, SimulationOptions, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';
import { counted, grouped } from '../core/words';
import { collisionSceneOf } from './colliders';
import type { BodyBinding } from '../body/body_binding';
import { layersAt } from '../body/layers';
import { materialOf } from '../body/material';
import type { MaterialSettings } from '../body/material';
import type { PinnedVertices } from '../body/pins';
import type { BodySize, PreparedBody } from '../body/prepared_body';
import { engineValues } from '../settings/engine_text';
import type { Settings } from '../settings/options';
import { untouchedSolvers } from '../solvers/solver_pair';
import type { SolverPair } from '../solvers/solver_pair';

/** Seconds of one step, whatever the number of substeps. */
export const STEP_SECONDS = 1 / 60;

/** The simulation model without a solver: with calibration shells, because solids on the same lattice need none. */
export const simulatedMaterial = ({ material, calibrate }: Settings): SimulationModel =>
  calibrate && material === 'solid' ? 'shell' : material;

/**
 * The options for simulating this body and any result of it, from the settings. `pinned` are vertices of the
 * original; null: the default pins of the scenario.
 */
export function simulationOptions(
  original: BodySize,
  settings: Settings,
  pinned: PinnedVertices | null,
): SimulationOptions {
  const { scenario, seconds, substeps, damping, selfCollision, friction, colliders } = settings;
  return {
    material: simulatedMaterial(settings),
    scenario,
    seconds,
    substeps,
    damping,
    selfCollision,
    friction,
    ...collisionSceneOf(colliders),
    pinned,
    ...materialOf(original, settings),
  };
}

/**
 * The solver of the settings on original and result, with the same numbers typed in for both; null where no
 * solver is chosen. Throws SettingError where the solver lacks a given parameter.
 */
export function untouchedSolversOf(
  size: BodySize,
  meshes: { original: TriangleMesh; result: TriangleMesh },
  settings: Settings,
): SolverPair | null {
  const { solver, engine, massRule, bendRatio } = settings;
  if (solver === 'none') return null;
  const { young, poisson, density, thickness, unit } = materialOf(size, settings);
  const material = { young, poisson, density, thickness: thickness * unit, bendRatio };
  const given = engineValues(solver, engine);
  return untouchedSolvers({ solver, massRule, given, material }, { ...meshes, unit });
}

/** The number of modes by which a body is calibrated. */
const CALIBRATION_MODES = 10;

/**
 * The factor on Young's modulus of `optimized` that makes its first ten frequencies those of the original, both as shells
 * of the material that the settings name: a coarse mesh is a little too soft or too stiff throughout.
 */
export function calibrationOf(
  core: Core,
  original: BodySize & { mesh: TriangleMesh },
  optimized: TriangleMesh,
  settings: MaterialSettings,
): number {
  const material = materialOf(original, settings);
  return core.calibrationFactor(original.mesh, optimized, { modeCount: CALIBRATION_MODES, ...material });
}

/**
 * The binding of a file in terms of two prepared bodies: per vertex of `original` its point on `optimized`. Throws an
 * Error with one sentence where the file is of other bodies, or of another result.
 */
export function bindingBetween(
  original: PreparedBody,
  optimized: PreparedBody,
  bodies: BodyBinding[],
): Pick<Binding, 'triangle' | 'barycentric'> {
  const { vertexOfSource } = original.weld;
  const entry = bodies.find(({ mesh }) => mesh === original.body.mesh);
  if (!entry || entry.binding.triangle.length !== vertexOfSource.length)
    throw new Error(
      `The binding is not of "${original.body.name}": write it again together with the optimized mesh.`,
    );
  const faces = faceCount({ triangles: optimized.body.indices });
  if (entry.faces !== faces)
    throw new Error(
      `The binding is of another result of "${original.body.name}", which has ${counted(entry.faces, 'face')} and not ${grouped(faces)}: write it again together with the optimized mesh.`,
    );
  const layerOf = new Map<number, { t: number; cornerOf: readonly number[] }>();
  for (let t = 0; t < faceCount(optimized.mesh); ++t)
    for (const { source, cornerOf } of layersAt(optimized.layers, t)) layerOf.set(source, { t, cornerOf });
  const count = vertexCount(original.mesh);
  const triangle = new Uint32Array(count).fill(NONE);
  const barycentric = new Float32Array(3 * count);
  vertexOfSource.forEach((v, source) => {
    const bound = entry.binding.triangle[source];
    const layer = layerOf.get(bound);
    if (v === NONE || !layer) return;
    triangle[v] = layer.t;
    layer.cornerOf.forEach((corner, k) => {
      barycentric[3 * v + corner] = entry.binding.barycentric[3 * source + k];
    });
  });
  return { triangle, barycentric };
}
