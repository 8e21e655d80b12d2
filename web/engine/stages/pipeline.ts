/**
 * The verbs over one body, in their order: prepare, find modes, find guidance, build the history, reduce, measure. Each
 * is one or a few calls of the core; the page's worker and the command line run the same ones, so they give the same bytes.
 */

import type { Document } from '@gltf-transform/core';
import { attributesOf, costAttributesOf, NO_ATTRIBUTES, ownSources, sourcesInBody } from '../body/attributes';
import type { BodyAttributes, CostAttributes } from '../body/attributes';
import { nextEnd } from './collapse_pairs';
import { ATTRIBUTE_LIMIT } from '../core/core';
import type {
  Core,
  Curvature,
  Fitted,
  History,
  Inspection,
  MeshAt,
  MirrorImages,
  ModeSet,
  Refused,
  SimplifyOptions,
  WhyKept,
  Quality,
  StrainGuidance,
  SurfaceDistance,
  TriangleMesh,
  WeldResult,
  SimplifyConstraints,
} from '../core/core';
import { endWithin } from './deviation_limit';
import type { ExportedBody } from '../document/export';
import { counted } from '../core/words';
import type { Body } from '../document/model';
import { length3 } from '../core/exact_math';
import type { Held } from '../body/constraints';
import { modesAvailable } from '../core/mode_set';
import { isFitted, methodOf, resolveModel, resolveModes, SettingError } from '../settings/options';
import type { Settings } from '../settings/options';
import type { InspectedBody } from '../report/report';
import { withMirror } from '../body/symmetry';

/** A body ready for everything else. */
export interface PreparedBody {
  body: Body;
  weld: WeldResult;
  /** the usable part, welded: what everything is computed on */
  mesh: TriangleMesh;
  /** of the bounding box of `mesh` */
  diagonal: number;
  /** of `mesh`; weld.inspection is of the body as it came */
  inspection: Inspection;
  quality: Quality;
  /** what its vertices carry besides their place */
  attributes: BodyAttributes;
  /** what attributes cost in a collapse */
  costAttributes: CostAttributes;
  /** where a symmetry is wished; `partners` are those of `mesh`, in which quads are cut as `corners` ask for */
  images?: MirrorImages;
}

/** What a material needs to know of a body. */
export interface BodySize {
  body: { scale: number };
  diagonal: number;
}

/** What an optimized mesh is like beside its original. */
export interface Measured {
  /** of the mesh as a reader of the file would weld it */
  weld: WeldResult;
  inspection: Inspection;
  quality: Quality;
  /** in % of the original's diagonal */
  distance: SurfaceDistance;
  certificate: Certificate;
}

/** Whether the topology is the original's. */
export interface Certificate {
  components: boolean;
  boundaryLoops: boolean;
  genus: boolean;
  /** all of them */
  kept: boolean;
}

/** Welds and measures a body, usable or not. */
export function inspectBody(core: Core, body: Body, settings: Settings): InspectedBody {
  const weld = core.weld(body.positions, body.indices, { tolerance: settings.weld });
  const quality = weld.mesh.triangles.length > 0 ? core.measureQuality(weld.mesh) : null;
  return { weld, inspection: core.inspect(weld.mesh), quality };
}

/**
 * Welds and inspects, and cuts quads the other way where a wished symmetry takes that. Throws an Error with one sentence where
 * the body has no usable face. `document` is where the body comes from; without it nothing is known of its attributes.
 */
export function prepareBody(core: Core, body: Body, settings: Settings, document?: Document): PreparedBody {
  const { symmetry } = settings;
  const prepared = prepareAsItStands(core, body, settings, document);
  return symmetry === 'off' ? prepared : withMirror(core, prepared, symmetry);
}

function prepareAsItStands(
  core: Core,
  body: Body,
  settings: Settings,
  document: Document | undefined,
): PreparedBody {
  const { weld, inspection, quality } = inspectBody(core, body, settings);
  const { mesh } = weld;
  if (quality === null)
    throw new Error(
      `Body "${body.name}" has no usable face, ${weld.degenerateFaces} with a repeated vertex: repair it and export it again.`,
    );
  const diagonal = diagonalOf(mesh);
  const attributes = document ? attributesOf(document, body, weld) : NO_ATTRIBUTES;
  const costs = document && costAttributesOf(document, body, weld, attributes, diagonal);
  const costAttributes = costs && costs.dimension <= ATTRIBUTE_LIMIT ? costs : NO_COSTS;
  return { body, weld, mesh, diagonal, inspection, quality, attributes, costAttributes };
}

/**
 * Elastic modes of every component, with the material of `settings` on the body in its first node's scale. `pinned`:
 * vertices of the prepared mesh, see `findPins`.
 */
export function findModes(
  core: Core,
  prepared: PreparedBody,
  settings: Settings,
  pinned: Uint32Array = new Uint32Array(),
): ModeSet {
  const { modeCount, direction, exact } = settings;
  return core.findModes(prepared.mesh, {
    model: resolveModel(settings),
    modeCount,
    direction: ['x', 'y', 'z'].indexOf(direction),
    pinned,
    exact,
    ...materialOf(prepared, settings),
  });
}

/** The material on this body: thickness in units of its mesh, and metres per such unit. */
export function materialOf({ body, diagonal }: BodySize, settings: Settings) {
  const { young, poisson, density, thickness, unit } = settings;
  return { young, poisson, density, thickness: (thickness / 100) * diagonal, unit: unit * body.scale };
}

/**
 * Strain and its rank per triangle for the guiding modes. A mode that the body lacks counts nothing, as in a part that
 * lacks it; the strain of a body without any elastic mode is 0. Throws where modes are named and none of them exists.
 */
export function findGuidance(
  core: Core,
  prepared: PreparedBody,
  modes: ModeSet,
  settings: Settings,
): StrainGuidance {
  const { modeWeights, p, strainThreshold: threshold } = settings;
  const available = modesAvailable(modes);
  const faces = prepared.mesh.triangles.length / 3;
  if (available === 0) return { strain: new Float32Array(faces), rank: new Float32Array(faces) };
  const asked = resolveModes(settings).map((mode, i) => ({ ordinal: mode - 1, weight: modeWeights[i] }));
  const found = asked.filter(({ ordinal }) => ordinal < available);
  if (found.length === 0) {
    const lowest = Math.min(...asked.map(({ ordinal }) => ordinal + 1));
    throw new SettingError(
      'modes',
      `names mode ${lowest}, but "${prepared.body.name}" has only ${available}: name a lower one.`,
    );
  }
  const weights = modeWeights.length > 0 ? found.map(({ weight }) => weight) : [];
  const ordinals = found.map(({ ordinal }) => ordinal);
  return core.strainGuidance(prepared.mesh, modes, { ordinals, weights, p, threshold });
}

/** What a history follows from, besides the settings. */
export interface Guides extends Held {
  guidance: StrainGuidance | null;
  curvature: Curvature;
}

/**
 * Every collapse down to the end. Without guidance the strain counts as 0; curvature enters over its maximum. The paper's
 * method knows nothing of attributes, as printed; for others borders of materials stay closed and in place, and, unless seams
 * are to be crossed, so do these, and attributes cost. A largest deviation holds as it is measured.
 */
export function buildHistory(
  core: Core,
  prepared: PreparedBody,
  guides: Guides,
  settings: Settings,
): History {
  const { strain, curvature, options } = simplification(prepared, guides, settings);
  const simplified = core.simplify(prepared.mesh, strain, curvature, options);
  const history = guides.mirror ? { ...simplified, mirror: guides.mirror } : simplified;
  if (settings.maxDeviation === 0) return history;
  const deviationAt = (faces: number) =>
    measureDistance(core, prepared, core.meshAt(prepared.mesh, history, faces).mesh).hausdorff;
  return endWithin(history, settings.maxDeviation, deviationAt);
}

/**
 * What keeps each vertex of reduceTo(core, prepared, history, faces); `guides` and `settings` as the history was built with.
 */
export function explainResult(
  core: Core,
  prepared: PreparedBody,
  { history, faces }: { history: History; faces: number },
  { guides, settings }: { guides: Guides; settings: Settings },
): WhyKept {
  const { strain, curvature, options } = simplification(prepared, guides, settings);
  return core.whyKept(prepared.mesh, strain, curvature, options, history, wholeFaces(history, faces));
}

/** What the core is told of a simplification. */
function simplification(
  prepared: PreparedBody,
  guides: Guides,
  settings: Settings,
): { strain: Float32Array; curvature: Float32Array; options: SimplifyOptions } {
  const { method, strainWeight, curvatureWeight, qualityWeight, sizeWeight, minAngle } = settings;
  const weights = { strainWeight, curvatureWeight, qualityWeight, sizeWeight };
  const maxDeviation = (settings.maxDeviation / 100) * prepared.diagonal;
  const constraints = constraintsOf(prepared, settings, guides);
  return {
    strain: guides.guidance?.rank ?? new Float32Array(0),
    curvature: overMaximum(guides.curvature.vertex),
    options: { method, ...weights, minAngle, maxDeviation, constraints },
  };
}

const NO_COSTS: CostAttributes = { values: new Float32Array(), dimension: 0 };

function constraintsOf(prepared: PreparedBody, settings: Settings, held: Held): SimplifyConstraints {
  const { borders, seams, creases } = settings;
  const pins = maskOf(prepared.mesh, held.pinned);
  const constraints = {
    pinnedSets: pins && Uint32Array.from(pins),
    locked: maskOf(prepared.mesh, held.locked),
    keep: held.keep,
    mirror: held.mirror,
    creaseAngle: creases,
    borders,
  };
  if (!methodOf(settings).keepsAttributes) return constraints;
  const { charts } = prepared.attributes;
  if (seams === 'cross') return { ...constraints, groups: charts.groups };
  const { values: attributes, dimension: attributeDimension } = prepared.costAttributes;
  return { ...constraints, ...charts, attributes, attributeDimension };
}

/** Whether seams are kept that hold most of the edges that are left. */
export function isHeldBySeams(
  { mesh, attributes }: PreparedBody,
  { lock, ...others }: Refused,
  settings: Settings,
): boolean {
  const hasSeams = attributes.wedgeCount > mesh.positions.length / 3;
  const isKept = settings.seams === 'keep' && methodOf(settings).keepsAttributes;
  return hasSeams && isKept && lock > Object.values(others).reduce((sum, count) => sum + count, 0);
}

/** Per vertex: 1 for those of the lists; undefined where they name none. */
function maskOf({ positions }: TriangleMesh, ...lists: (Uint32Array | undefined)[]): Uint8Array | undefined {
  if (lists.every((vertices) => !vertices?.length)) return undefined;
  const mask = new Uint8Array(positions.length / 3);
  for (const vertices of lists) vertices?.forEach((vertex) => (mask[vertex] = 1));
  return mask;
}

/**
 * The largest mesh of the history with at most `faces` faces, or the floor. A history that keeps a mirror symmetry is not
 * cut between a collapse and its image.
 */
export function reduceTo(core: Core, prepared: PreparedBody, history: History, faces: number): MeshAt {
  return core.meshAt(prepared.mesh, history, wholeFaces(history, faces));
}

function wholeFaces(history: History, faces: number): number {
  const whole = history.mirror ? wholePairs(history, faces) : faces;
  return Math.max(0, Math.floor(whole));
}

/** The largest number of faces up to `faces` that is not left in the middle of a pair; at least that of the floor. */
function wholePairs(history: History, faces: number): number {
  for (let end = 0; end < history.kept.length;) {
    end = nextEnd(history, end);
    const left = history.trianglesAfter[end - 1];
    if (left <= faces) return left;
  }
  return faces;
}

/** What the fit may use of the largest deviation: it looks at samples, and where these miss too much, a second one keeps away. */
const DEVIATION_SHARES = [1, 0.85];

/** `unfitted`: why the result, or parts of it, stay as the collapses left them; '' where nothing does. */
export interface FittedResult extends Fitted {
  unfitted: string;
}

/**
 * The result, fitted to the original's modes where the settings say so; pinned and locked vertices stay, and so does a mirror
 * symmetry. Where the fit would break the largest deviation or the smallest angle that the settings ask for, the result stays
 * as it is.
 */
export function fitResult(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  { settings, ...held }: Held & { settings: Settings },
): FittedResult {
  const none = {
    result,
    errorBefore: new Float64Array(),
    errorAfter: new Float64Array(),
    large: 0,
    tooLarge: 0,
  };
  if (!isFitted(settings)) return { ...none, unfitted: '' };
  const { thickness, poisson } = materialOf(prepared, settings);
  const { mesh } = prepared;
  const locked = maskOf(mesh, held.pinned, held.locked) ?? new Uint8Array();
  const pinned = maskOf(mesh, held.pinned) ?? new Uint8Array();
  const { charts } = prepared.attributes;
  const holdsSeams = settings.seams === 'keep';
  const request = { thickness, poisson, charts, holdsSeams, locked, pinned, mirror: held.mirror };
  for (const share of settings.maxDeviation > 0 ? DEVIATION_SHARES : [1]) {
    const maxDeviation = ((share * settings.maxDeviation) / 100) * prepared.diagonal;
    const limits = { maxDeviation, minAngle: settings.minAngle };
    const fitted = core.fitModes(mesh, result, { ...request, ...limits });
    if (keepsTargets(core, prepared, [result.mesh, fitted.result.mesh], settings))
      return { ...fitted, unfitted: describeUnfitted(fitted) };
  }
  return { ...none, unfitted: 'the fit would break a limit of deviation or angle' };
}

/** How large parts were fitted; '' where there are none. */
export function describeLargeFit({ large }: Fitted): string {
  if (large === 0) return '';
  const parts = counted(large, 'part has', 'parts have');
  return `${parts} more than 20,000 vertices, fitted to the modes at half and twice the thickness, in six rounds`;
}

function describeUnfitted({ tooLarge }: Fitted): string {
  if (tooLarge === 0) return '';
  return `${counted(tooLarge, 'part has', 'parts have')} more than 20,000 vertices, of too many in the original to fit`;
}

/** Whether `after` holds the targets of shape, or at least as well as `before`. */
function keepsTargets(
  core: Core,
  prepared: PreparedBody,
  [before, after]: [TriangleMesh, TriangleMesh],
  { maxDeviation, minAngle }: Settings,
): boolean {
  const angleOf = (mesh: TriangleMesh) => core.measureQuality(mesh).minAngle;
  const deviationOf = (mesh: TriangleMesh) => measureDistance(core, prepared, mesh).hausdorff;
  if (minAngle > 0 && angleOf(after) < Math.min(minAngle, angleOf(before))) return false;
  if (maxDeviation === 0) return true;
  const deviation = deviationOf(after);
  return deviation <= maxDeviation || deviation <= deviationOf(before);
}

/** Quality, distance and topology of a result, as a reader of the exported file finds it. */
export function measureResult(core: Core, prepared: PreparedBody, result: MeshAt): Measured {
  const weld = core.weld(result.mesh.positions, result.mesh.triangles, { tolerance: 0 });
  const { inspection } = weld;
  return {
    weld,
    inspection,
    quality: core.measureQuality(result.mesh),
    distance: measureDistance(core, prepared, result.mesh),
    certificate: compareTopology(prepared.inspection, inspection),
  };
}

/** Between the prepared mesh and `other`, in % of the prepared mesh's diagonal. */
export function measureDistance(core: Core, prepared: PreparedBody, other: TriangleMesh): SurfaceDistance {
  const distance = core.measureSurfaceDistance(prepared.mesh, other);
  const percent = 100 / prepared.diagonal;
  return {
    hausdorff: percent * distance.hausdorff,
    mean: percent * distance.mean,
    vertexHausdorff: percent * distance.vertexHausdorff,
  };
}

export function compareTopology(before: Inspection, after: Inspection): Certificate {
  const components = before.components === after.components;
  const boundaryLoops = before.boundaryLoops === after.boundaryLoops;
  const genus = before.genus === after.genus && before.eulerCharacteristic === after.eulerCharacteristic;
  return { components, boundaryLoops, genus, kept: components && boundaryLoops && genus };
}

/** What `exportGlb` wants to know of a result. Fields go from triangles to vertices as means over the input's faces. */
export function exportedBody(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  fields: { guidance: StrainGuidance | null; curvature: Curvature } | null,
): ExportedBody {
  const { body, weld, attributes } = prepared;
  const sources = core.sourceOfCorners(prepared.mesh, attributes.charts, result);
  const exported = {
    body,
    mesh: result.mesh,
    inputOfTriangle: result.inputOfTriangle.map((triangle) => weld.sourceOfTriangle[triangle]),
    sources: sourcesInBody(body, weld, sources),
    isFaceted: attributes.isFaceted,
  };
  if (!fields) return exported;
  const strain = meanOverTriangles(prepared.mesh, fields.guidance?.rank);
  const ofResult = (field: Float32Array) =>
    Float32Array.from(result.inputOfVertex, (vertex) => field[vertex]);
  return {
    ...exported,
    fields: { strain: ofResult(strain), curvature: ofResult(fields.curvature.vertex) },
  };
}

/** The body as it is, welded. */
export function exportedMesh({ body, mesh, weld, attributes }: PreparedBody): ExportedBody {
  const sources = sourcesInBody(body, weld, ownSources(mesh));
  return { body, mesh, inputOfTriangle: weld.sourceOfTriangle, sources, isFaceted: attributes.isFaceted };
}

/** Seconds since the last call of the function that this returns. */
export function startStopwatch(): () => number {
  let last = performance.now();
  return () => {
    const now = performance.now();
    const seconds = (now - last) / 1000;
    last = now;
    return seconds;
  };
}

/** Per vertex, the mean of the triangles around it; 0 without a field. */
function meanOverTriangles({ positions, triangles }: TriangleMesh, field?: Float32Array): Float32Array {
  const sums = new Float64Array(positions.length / 3);
  const counts = new Uint32Array(sums.length);
  if (field)
    triangles.forEach((vertex, corner) => {
      sums[vertex] += field[Math.floor(corner / 3)];
      counts[vertex] += 1;
    });
  return Float32Array.from(sums, (sum, vertex) => (counts[vertex] > 0 ? sum / counts[vertex] : 0));
}

function overMaximum(field: Float32Array): Float32Array {
  const maximum = field.reduce((largest, value) => Math.max(largest, value), 0);
  return maximum > 0 ? field.map((value) => value / maximum) : field;
}

function diagonalOf({ positions }: TriangleMesh): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  });
  return length3(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}
