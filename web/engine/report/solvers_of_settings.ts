/** Applies a settings file to a mesh that was read from its own file, to simulate it again. */

import type { SimulatedSolver, SolverModel, TriangleMesh } from '../core/core';
import { NONE } from '../core/core';
import { faceCount, vertexCount } from '../core/mesh';
import { counted } from '../core/words';
import { positionsInFile, verticesInFile, weldedVerticesInFile } from '../body/file_vertices';
import type { PreparedBody } from '../body/prepared_body';
import { SettingError } from '../settings/errors';
import { constraintVertices } from '../solvers/constraint_vertices';
import { meshFacts } from '../solvers/mesh_facts';
import type { MeshFacts } from '../solvers/mesh_facts';
import { profileOf } from '../solvers/profiles';
import type { SolverPair } from '../solvers/solver_pair';
import { modelOf } from '../solvers/tuned_body';
import type { BodySettings, SettingsFile } from './settings_file';

/**
 * The solvers of the original and its result according to a settings file. `unit`: metres per unit of their meshes. Throws an
 * Error with one sentence where the file is not of this result, SettingError where it is of another unit.
 */
export function solversOfSettings(
  { solver, bodies }: SettingsFile,
  original: TriangleMesh,
  result: PreparedBody,
  unit: number,
): SolverPair {
  const ownUnit = unit * (result.body.own?.scale ?? 1);
  const entry = entryOf(bodies, result, ownUnit);
  if (!isOfUnit(entry, ownUnit))
    throw new SettingError(
      'unit',
      `makes ${ownUnit} m of a unit of "${entry.name}", but its settings are for ${entry.unit} m: give the unit that they were made with.`,
    );
  const facts = meshFacts(original, unit);
  checkOriginal(entry, facts);
  const profile = profileOf(solver);
  const model = modelOf(profile, entry.mass.rule);
  const constants = profile.constants(entry.original, facts);
  return {
    original: { model: modelOf(profile, entry.mass.original ?? 'auto'), constants },
    result: solverOfEntry(entry, { model, unit }, result),
  };
}

/** Throws an Error where the original is another one than in the settings file. */
function checkOriginal({ name, original }: BodySettings, { vertices, faces }: MeshFacts): void {
  if (original.vertices === vertices && original.faces === faces) return;
  const [wanted, found] = [original, { vertices, faces }].map(
    (one) => `${counted(one.vertices, 'vertex', 'vertices')} and ${counted(one.faces, 'face')}`,
  );
  throw new Error(
    `The settings of "${name}" are for an original of ${wanted}, but this one has ${found}: name the mesh that they were made from.`,
  );
}

const isOfUnit = (entry: BodySettings, unit: number): boolean => Math.abs(entry.unit / unit - 1) <= 1e-9;

/**
 * The entry of a body among all levels: one with its numbers of vertices and faces; of several one that has its unit too, and whose
 * vertices are nearest; of equally near ones, as copies with one name have them, that of its mesh in the file.
 */
function entryOf(bodies: BodySettings[], result: PreparedBody, unit: number): BodySettings {
  const { body, mesh } = result;
  const vertices = verticesInFile(body).length;
  const found = bodies.filter(
    (entry) =>
      entry.name === body.name &&
      entry.renderVertices.length === vertices &&
      entry.mesh.triangles.length === mesh.triangles.length,
  );
  const ofUnit = found.filter((entry) => isOfUnit(entry, unit));
  const candidates = ofUnit.length > 0 ? ofUnit : found;
  if (candidates.length > 0) {
    const distances = candidates.map((entry) => distanceOf(entry, result));
    const least = Math.min(...distances);
    const nearest = candidates.filter((_, i) => distances[i] === least);
    return nearest.find(({ meshNumber }) => meshNumber === body.mesh) ?? nearest[0];
  }
  throw new Error(
    `The settings are not of "${body.name}" with ${counted(faceCount(mesh), 'face')}: take those that were written with this file.`,
  );
}

/** The solver with the masses and factors of the entry, in the order of the prepared mesh. */
function solverOfEntry(
  entry: BodySettings,
  { model, unit }: { model: SolverModel; unit: number },
  result: PreparedBody,
): SimulatedSolver {
  const of = verticesOf(entry, result);
  const masses = Float64Array.from(of, (v) => entry.mass.perVertex[v]);
  const { area } = meshFacts(result.mesh, unit);
  const total = masses.reduce((sum, mass) => sum + mass, 0);
  const [stretch, bend] = [entry.stretch, entry.bend];
  const constants = {
    stretch: stretch.constant,
    secondStretch: stretch.second ?? 0,
    bend: bend.constant,
    poisson: entry.engine.poisson ?? 0,
    surfaceDensity: total / area,
    unit,
  };
  const here = constraintVertices(result.mesh, model);
  const there = constraintVertices(asMesh(entry), model);
  const listed = {
    stretch: new ListedFactors(
      listOf(stretch.pairs, 2) ?? there.stretch,
      stretch.factors,
      entry.vertex?.stretch,
    ),
    bend: new ListedFactors(
      listOf(bend.pairs, 2) ?? listOf(bend.hinges, 4) ?? there.bend,
      bend.factors,
      entry.vertex?.bend,
    ),
  };
  const factors = (kind: 'stretch' | 'bend') =>
    Float64Array.from(here[kind], (vertices) => listed[kind].take(vertices.map((v) => of[v])));
  return {
    model,
    constants,
    masses,
    ...(listed.stretch.isEmpty ? {} : { stretchFactors: factors('stretch') }),
    ...(listed.bend.isEmpty || model.bend === 'morley' ? {} : { bendFactors: factors('bend') }),
  };
}

const asMesh = ({ mesh: { positions, triangles } }: BodySettings): TriangleMesh => ({
  positions: Float32Array.from(positions),
  triangles: Uint32Array.from(triangles),
});

function listOf(flat: number[] | undefined, size: number): number[][] | null {
  if (!flat) return null;
  return Array.from({ length: flat.length / size }, (_, c) => flat.slice(size * c, size * c + size));
}

/**
 * The sum of squared distances of the vertices of a body from those that the entry has for them, in units of the file's mesh; Infinity
 * where it has none for one.
 */
function distanceOf(entry: BodySettings, result: PreparedBody): number {
  const of = verticesByFile(entry, result);
  const there = (i: number): number => entry.mesh.positions[3 * of[Math.floor(i / 3)] + (i % 3)] ?? Infinity;
  return positionsInFile(result).reduce((sum, here, i) => sum + (here - there(i)) ** 2, 0);
}

/** Per vertex of the prepared mesh its vertex in the settings; NONE where they have none for it. */
function verticesByFile({ renderVertices }: BodySettings, result: PreparedBody): Uint32Array {
  const of = new Uint32Array(vertexCount(result.mesh)).fill(NONE);
  weldedVerticesInFile(result).forEach((vertex, i) => {
    if (vertex >= 0 && renderVertices[i] >= 0) of[vertex] = renderVertices[i];
  });
  return of;
}

/** Per vertex of the prepared mesh its vertex in the settings. Throws where they have none for one. */
function verticesOf(entry: BodySettings, result: PreparedBody): Uint32Array {
  const of = verticesByFile(entry, result);
  if (of.includes(NONE))
    throw new Error(
      `The settings of "${entry.name}" are of another mesh: take those that were written with this file.`,
    );
  return of;
}

/** Looks up factors by the vertices of their constraints. */
class ListedFactors {
  private readonly queues = new Map<string, number[]>();
  readonly isEmpty: boolean;

  constructor(
    lists: number[][],
    factors: number[] | undefined,
    private readonly field: number[] | undefined,
  ) {
    this.isEmpty = !factors && !field;
    if (factors)
      lists.forEach((vertices, c) => {
        const key = keyOf(vertices);
        this.queues.set(key, [...(this.queues.get(key) ?? []), factors[c]]);
      });
  }

  /** The factor of the constraint on these vertices; for several constraints on the same vertices, one after the other. */
  take(vertices: number[]): number {
    const own = this.queues.get(keyOf(vertices))?.shift() ?? 1;
    if (!this.field) return own;
    const { field } = this;
    return (own * vertices.reduce((sum, v) => sum + field[v], 0)) / vertices.length;
  }
}

const keyOf = (vertices: number[]): string => [...vertices].sort((a, b) => a - b).join(' ');
