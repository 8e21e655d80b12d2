/** Reads and validates a settings file. */

import { ENGINE_MATERIAL } from '../body/material';
import { isCount } from '../core/count';
import { OPTIONS } from '../settings/table';
import { profileOf, SOLVER_NAMES } from '../solvers/profiles';
import type { SolverName } from '../solvers/profiles';
import { SETTINGS_SCHEMA } from './settings_file';
import type { BodySettings, SettingsFile } from './settings_file';

/** Says what is wrong with the entry of a body; null: nothing. */
type Check = (body: BodySettings, vertices: number, faces: number) => string | null;

const isNumbers = (value: unknown): value is number[] =>
  Array.isArray(value) && value.every((entry) => typeof entry === 'number' && Number.isFinite(entry));

const isIndices = (value: unknown, end: number, size = 1): boolean =>
  isNumbers(value) &&
  value.length % size === 0 &&
  value.every((v) => Number.isInteger(v) && v >= 0 && v < end);

const isPositive = (values: unknown, length: number): boolean =>
  isNumbers(values) && values.length === length && values.every((value) => value > 0);

const isPositiveNumber = (value: unknown): boolean =>
  typeof value === 'number' && Number.isFinite(value) && value > 0;

/** Whether a value is an object of numbers with these names and maybe others. */
const hasNumbers = (value: unknown, names: readonly string[]): boolean =>
  typeof value === 'object' &&
  value !== null &&
  isNumbers(Object.values(value)) &&
  names.every((name) => Object.hasOwn(value, name));

/** Files of the first versions do not say what was given. */
const namesParameters = (names: unknown, solver: SolverName): boolean =>
  names === undefined ||
  (Array.isArray(names) &&
    names.every((name) => profileOf(solver).parameters.some((parameter) => parameter.name === name)));

const ORIGINAL_NUMBERS = ['vertices', 'faces', 'totalMass', 'stretch', 'bend'];

const CHECKS: readonly Check[] = [
  ({ meshNumber }) =>
    meshNumber === undefined || isCount(meshNumber)
      ? null
      : 'a mesh number that is not a whole number from 0',
  ({ unit }) => (isPositiveNumber(unit) ? null : 'a unit that is not a length'),
  ({ engine, original }) =>
    hasNumbers(engine, []) && hasNumbers(original, ORIGINAL_NUMBERS)
      ? null
      : 'damaged parameters of the engine or of the original',
  ({ mesh }, vertices) =>
    isIndices(mesh.triangles, vertices, 3) ? null : 'triangles that refer to vertices it does not have',
  ({ renderVertices }, vertices) =>
    isNumbers(renderVertices) && renderVertices.every((v) => Number.isInteger(v) && v >= -1 && v < vertices)
      ? null
      : 'render vertices that refer to vertices it does not have',
  ({ mass }, vertices) =>
    isPositive(mass.perVertex, vertices) ? null : 'masses that are not one number above 0 for each vertex',
  ({ mass }) =>
    [undefined, 'area', 'vertex'].includes(mass.original)
      ? null
      : 'a mass rule that is neither area nor vertex',
  ({ vertex }, vertices) =>
    !vertex || (isPositive(vertex.stretch, vertices) && isPositive(vertex.bend, vertices))
      ? null
      : 'factors that are not two numbers above 0 for each vertex',
  ({ stretch }, vertices, faces) => {
    const count = stretch.pairs ? stretch.pairs.length / 2 : faces;
    return isIndices(stretch.pairs ?? [], vertices, 2) && hasFactors(stretch, count)
      ? null
      : 'damaged stretching constraints';
  },
  ({ bend }, vertices) => {
    const isListed = isIndices(bend.pairs ?? [], vertices, 2) && isIndices(bend.hinges ?? [], vertices, 4);
    const count = (bend.pairs?.length ?? 0) / 2 + (bend.hinges?.length ?? 0) / 4;
    return isListed && hasFactors(bend, count) ? null : 'damaged bending constraints';
  },
  ({ pins }, vertices) => (isIndices(pins, vertices) ? null : 'pins that refer to vertices it does not have'),
];

const hasFactors = (
  { constant, factors }: { constant: unknown; factors?: unknown },
  count: number,
): boolean =>
  typeof constant === 'number' && constant >= 0 && (factors === undefined || isPositive(factors, count));

/**
 * Throws an Error with one sentence where `text`, the content of the file `name`, is no valid settings file. `cure`: how the caller can get
 * a valid one.
 */
export function readSettingsFile(
  name: string,
  text: string,
  cure = 'write it again with limber optimize --settings',
): SettingsFile {
  const fail = (problem: string): never => {
    throw new Error(`${name} ${problem}: ${cure}.`);
  };
  const file = parse(text) ?? fail('is not JSON');
  if (file.schema !== SETTINGS_SCHEMA)
    return fail(`is no settings file, because its "schema" is not "${SETTINGS_SCHEMA}"`);
  if (!Array.isArray(file.bodies) || file.bodies.length === 0) return fail('has no bodies');
  if (!(SOLVER_NAMES as readonly unknown[]).includes(file.solver))
    return fail(
      typeof file.solver === 'string'
        ? `is for "${file.solver}", which is not one of ${SOLVER_NAMES.join(', ')}`
        : `names none of the solvers ${SOLVER_NAMES.join(', ')}`,
    );
  if (!(OPTIONS.tune.choices as readonly unknown[]).includes(file.tune))
    return fail(`has a tuning that is not one of ${OPTIONS.tune.choices.join(', ')}`);
  if (!isPositiveNumber((file.units as { length?: unknown } | null | undefined)?.length))
    return fail('has a unit that is not a length');
  if (file.material !== undefined && !hasNumbers(file.material, ENGINE_MATERIAL))
    return fail('has a damaged material');
  if (!namesParameters(file.given, file.solver as SolverName))
    return fail('has parameters that its solver does not have');
  for (const body of file.bodies as BodySettings[]) {
    const problem = problemOf(body);
    if (problem)
      fail(
        `has ${problem} for ${typeof body?.name === 'string' ? `"${body.name}"` : 'a body without a name'}`,
      );
  }
  return file as unknown as SettingsFile;
}

function problemOf(body: BodySettings): string | null {
  const parts = [body?.mesh, body?.mass, body?.stretch, body?.bend];
  if (parts.some((part) => part === null || typeof part !== 'object'))
    return 'no mesh, mass, stretch or bend';
  const { positions, triangles } = body.mesh;
  if (!isNumbers(positions) || positions.length % 3 !== 0) return 'damaged positions';
  const [vertices, faces] = [positions.length / 3, (triangles?.length ?? 0) / 3];
  return CHECKS.reduce<string | null>((found, check) => found ?? check(body, vertices, faces), null);
}

/** null where the text is not a JSON object. */
function parse(text: string): Record<string, unknown> | null {
  try {
    const value = JSON.parse(text) as unknown;
    return typeof value === 'object' ? (value as Record<string, unknown> | null) : null;
  } catch {
    return null;
  }
}
