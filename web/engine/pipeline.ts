/**
 * The verbs over one body, in their order: prepare, find modes, find guidance, build the history, reduce, measure. Each
 * is one or a few calls of the core; the page's worker and the command line run the same ones, so they give the same bytes.
 */

import type { Document } from '@gltf-transform/core';
import { attributesOf, costAttributesOf, NO_ATTRIBUTES, ownSources, sourcesInBody } from './attributes';
import type { BodyAttributes, CostAttributes } from './attributes';
import type {
  Core,
  Curvature,
  Fitted,
  History,
  Inspection,
  MeshAt,
  ModeSet,
  Quality,
  StrainGuidance,
  SurfaceDistance,
  TriangleMesh,
  WeldResult,
  Wishes,
} from './core';
import type { ExportedBody } from './document/export';
import type { Body } from './document/model';
import { length3 } from './exact_math';
import { modesAvailable } from './mode_set';
import { isFitted, resolveModel, resolveModes } from './options';
import { LOCKED, paintOn, wishesOfLevels } from './paint';
import type { Settings } from './options';
import type { InspectedBody } from './report';

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

/** Seconds by stage. */
export interface Timings {
  weld: number;
  modes: number;
  /** strain and curvature */
  fields: number;
  /** from the guidance to the whole history */
  simplify: number;
  /** evaluating the history at the asked count */
  reduce: number;
  /** to the original's modes */
  fit: number;
  measure: number;
}

export interface OptimizedBody {
  prepared: PreparedBody;
  /** null for a method that needs none */
  modes: ModeSet | null;
  guidance: StrainGuidance | null;
  curvature: Curvature;
  history: History;
  targetFaces: number;
  /** the final mesh */
  result: MeshAt;
  fitted: Fitted;
  measured: Measured;
  timings: Timings;
}

/** Welds and measures a body, usable or not. */
export function inspectBody(core: Core, body: Body, settings: Settings): InspectedBody {
  const weld = core.weld(body.positions, body.indices, { tolerance: settings.weld });
  const quality = weld.mesh.triangles.length > 0 ? core.measureQuality(weld.mesh) : null;
  return { weld, inspection: core.inspect(weld.mesh), quality };
}

/**
 * Welds and inspects. Throws an Error with one sentence where the body has no usable face. `document` is where the body
 * comes from; without it nothing is known of its attributes.
 */
export function prepareBody(core: Core, body: Body, settings: Settings, document?: Document): PreparedBody {
  const { weld, inspection, quality } = inspectBody(core, body, settings);
  const { mesh } = weld;
  if (quality === null)
    throw new Error(
      `Body "${body.name}" has no usable face, ${weld.degenerateFaces} with a repeated vertex: repair it and export it again.`,
    );
  const diagonal = diagonalOf(mesh);
  const attributes = document ? attributesOf(document, body, weld) : NO_ATTRIBUTES;
  const costs = document && costAttributesOf(document, body, weld, attributes, diagonal);
  const costAttributes = costs && costs.dimension <= MOST_COST_DIMENSIONS ? costs : NO_COSTS;
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
  const asked = resolveModes(settings).map((mode, i) => ({ layer: mode - 1, weight: modeWeights[i] }));
  const found = asked.filter(({ layer }) => layer < available);
  if (found.length === 0) {
    const lowest = Math.min(...asked.map(({ layer }) => layer + 1));
    throw new Error(
      `--mode names mode ${lowest}, but "${prepared.body.name}" has only ${available}: name a lower one.`,
    );
  }
  const weights = modeWeights.length > 0 ? found.map(({ weight }) => weight) : [];
  const layers = found.map(({ layer }) => layer);
  return core.strainGuidance(prepared.mesh, modes, { layers, weights, p, threshold });
}

/**
 * Every collapse down to the end. Without guidance the strain counts as 0; curvature enters over its maximum. `pinned`
 * vertices keep their outline. The paper's method knows nothing of attributes, as printed; for others seams and borders of
 * materials stay closed and in place, and attributes cost.
 */
export function buildHistory(
  core: Core,
  prepared: PreparedBody,
  guides: { guidance: StrainGuidance | null; curvature: Curvature; pinned?: Uint32Array },
  settings: Settings,
): History {
  const { method, strainWeight, curvatureWeight, qualityWeight, sizeWeight, minAngle } = settings;
  const strain = guides.guidance?.rank ?? new Float32Array(0);
  return core.simplify(prepared.mesh, strain, overMaximum(guides.curvature.vertex), {
    method,
    strainWeight,
    curvatureWeight,
    qualityWeight,
    sizeWeight,
    minAngle,
    maxDeviation: (settings.maxDeviation / 100) * prepared.diagonal,
    wishes: wishesOf(prepared, settings, guides.pinned),
  });
}

/** What the core takes of them. */
const MOST_COST_DIMENSIONS = 8;
const NO_COSTS: CostAttributes = { values: new Float32Array(), dimension: 0 };

function wishesOf(prepared: PreparedBody, settings: Settings, pinned?: Uint32Array): Wishes {
  const { method, borders } = settings;
  const pinnedSets =
    pinned && pinned.length > 0 ? Uint32Array.from(maskOf(prepared.mesh, pinned)) : undefined;
  const painted = paintOn(settings.paint, prepared);
  const asked = { pinnedSets, borders, ...(painted ? wishesOfLevels(painted) : {}) };
  if (method === 'paper') return asked;
  const { charts } = prepared.attributes;
  const { values: attributes, dimension: attributeDimension } = prepared.costAttributes;
  return { ...charts, attributes, attributeDimension, ...asked };
}

/** Per vertex: 1 where the fit moves nothing, for it is pinned or locked. */
function stayingIn(prepared: PreparedBody, { paint }: Settings, pinned?: Uint32Array): Uint8Array {
  const mask = maskOf(prepared.mesh, pinned ?? new Uint32Array());
  paintOn(paint, prepared)?.forEach((level, vertex) => {
    if (level === LOCKED) mask[vertex] = 1;
  });
  return mask;
}

/** Per vertex: 1 for those of the list. */
function maskOf({ positions }: TriangleMesh, vertices: Uint32Array): Uint8Array {
  const mask = new Uint8Array(positions.length / 3);
  for (const vertex of vertices) mask[vertex] = 1;
  return mask;
}

/** The largest mesh of the history with at most `faces` faces, or the floor. */
export function reduceTo(core: Core, prepared: PreparedBody, history: History, faces: number): MeshAt {
  return core.meshAt(prepared.mesh, history, Math.max(0, Math.floor(faces)));
}

/**
 * The result, fitted to the original's modes where the settings say so; pinned vertices stay. Where the fit would break the
 * largest deviation or the smallest angle that the settings ask for, the result stays as it is.
 */
export function fitResult(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  { settings, pinned }: { settings: Settings; pinned?: Uint32Array },
): Fitted {
  const none = { result, errorBefore: new Float64Array(), errorAfter: new Float64Array() };
  if (!isFitted(settings)) return none;
  const { thickness, poisson } = materialOf(prepared, settings);
  const locked = stayingIn(prepared, settings, pinned);
  const { charts } = prepared.attributes;
  const fitted = core.fitModes(prepared.mesh, result, { thickness, poisson, charts, locked });
  return keepsTargets(core, prepared, [result.mesh, fitted.result.mesh], settings) ? fitted : none;
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
  return maxDeviation === 0 || deviationOf(after) <= Math.max(maxDeviation, deviationOf(before));
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

/** Everything in order. `targetFaces` says how many of the usable faces may stay. */
export function optimizeBody(
  core: Core,
  prepared: PreparedBody,
  settings: Settings,
  { targetFaces, pinned }: { targetFaces: number; pinned?: Uint32Array },
): OptimizedBody {
  const stopwatch = startStopwatch();
  const needsModes = settings.method !== 'qem';
  const modes = needsModes ? findModes(core, prepared, settings, pinned) : null;
  const modesTime = stopwatch();
  const guidance = modes ? findGuidance(core, prepared, modes, settings) : null;
  const curvature = core.meanCurvature(prepared.mesh);
  const fields = stopwatch();
  const history = buildHistory(core, prepared, { guidance, curvature, pinned }, settings);
  const simplify = stopwatch();
  const reduced = reduceTo(core, prepared, history, targetFaces);
  const reduce = stopwatch();
  const fitted = fitResult(core, prepared, reduced, { settings, pinned });
  const fit = stopwatch();
  const measured = measureResult(core, prepared, fitted.result);
  const timings = { weld: 0, modes: modesTime, fields, simplify, reduce, fit, measure: stopwatch() };
  const { result } = fitted;
  return { prepared, modes, guidance, curvature, history, targetFaces, result, fitted, measured, timings };
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
  return { mesh, inputOfTriangle: weld.sourceOfTriangle, sources, isFaceted: attributes.isFaceted };
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
