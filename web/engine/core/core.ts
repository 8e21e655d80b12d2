/**
 * The typed face of the C++ core: plain data and free functions, the same names as in `wasm/`. Typed arrays are copied at
 * the edge, in and out; nothing here remembers anything between calls but a running simulation (see simulation.ts).
 */

import type { ScenarioName } from './scenarios';

/** An indexed triangle surface; corners counter-clockwise seen from outside. Every coordinate is a float32. */
export interface TriangleMesh {
  /** positions[3 * v + c], in units of the file */
  positions: Float32Array;
  /** triangles[3 * t + corner], vertex indices */
  triangles: Uint32Array;
}

export interface WeldOptions {
  /** vertices closer than this become one, in % of the bounding box's diagonal; 0: bitwise equal positions only */
  tolerance: number;
}

/** A body ready for everything else, and where its parts came from. */
export interface WeldResult {
  mesh: TriangleMesh;
  /** per source vertex: its vertex in `mesh`, or NONE where no usable face needs it */
  vertexOfSource: Uint32Array;
  /** per triangle of `mesh`: its index in the source */
  sourceOfTriangle: Uint32Array;
  weldedVertices: number;
  degenerateFaces: number;
  duplicateFaces: number;
  flippedFaces: number;
  /** the source as it came: welded, degenerate faces dropped, duplicates still there */
  inspection: Inspection;
}

export const NONE = 0xffffffff;

/** What a mesh is like, and what is wrong with it. */
export interface Inspection {
  vertices: number;
  faces: number;
  components: number;
  boundaryLoops: number;
  /** summed over components; null where the mesh is non-manifold or not orientable */
  genus: number | null;
  eulerCharacteristic: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  orientationClashes: number;
}

/** In the order of `enum class Model` in wasm/elastic/modes.h, which ends with `auto`. */
export const MODELS = ['laplacian', 'shell', 'solid'] as const;
export type Model = (typeof MODELS)[number];

/** `local`: little of the surface takes part; see wasm/elastic/mode_character.h for the rule. */
export const MODE_NAMES = ['bend', 'twist', 'stretch', 'breathe', 'local'] as const;
export type ModeName = (typeof MODE_NAMES)[number];

export interface ModesOptions {
  /** 'auto': solid for closed parts, shell for others */
  model: Model | 'auto';
  /** laplacian: 0 x, 1 y, 2 z; -1: every mode along each principal axis in turn */
  direction: number;
  /** vertices that are held in place */
  pinned: Uint32Array;
  /** false: shells of more than 8,000 vertices are solved on a decimated copy and refined */
  exact: boolean;
  /** elastic modes per component */
  modeCount: number;
  /** in units of the mesh */
  thickness: number;
  /** Pa */
  young: number;
  poisson: number;
  /** kg/m3 */
  density: number;
  /** metres per unit of the mesh */
  unit: number;
}

/** One elastic mode of one component. */
export interface Mode {
  /** rad/s */
  omega: number;
  /** |K phi - lambda M phi| / (lambda |M phi|) */
  residual: number;
  component: number;
  /** it is the component's (ordinal + 1)-th elastic mode */
  ordinal: number;
  /** laplacian: the principal axis it moves along, 0 shortest .. 2 longest; otherwise -1 */
  axis: number;
  name: ModeName;
}

export interface ComponentModes {
  faces: number;
  model: Model;
  /** the component whose modes it takes part in: itself, but for a cavity of a solid */
  host: number;
  /** of the copy that was solved in its place; 0: solved as it is */
  coarseVertices: number;
  zeroModesExpected: number;
  zeroModesFound: number;
  modeCount: number;
}

/** Modes of every component. Ordinal k holds, at each vertex, the (k + 1)-th elastic mode of the vertex's own component. */
export interface ModeSet {
  /** ascending by omega */
  modes: Mode[];
  components: ComponentModes[];
  modesPerComponent: number;
  /** shapes[(ordinal * vertexCount + v) * 3 + c]; the largest displacement of each component's shape is 1 */
  shapes: Float32Array;
  /** per vertex */
  componentOfVertex: Uint32Array;
  factorNonzeros: number;
}

export interface GuidanceOptions {
  /** modes by number from 0, each component's own */
  ordinals: number[];
  /** w_k of Eq. 6 per entry of `ordinals`; empty: 1 / omega_k^2 */
  weights: number[];
  /** in [1, Infinity] */
  p: number;
  /** ranks below it count as 0, in [0, 1] */
  threshold: number;
}

export interface StrainGuidance {
  /** per triangle: sigma of Eq. 6 */
  strain: Float32Array;
  /** per triangle: rank within its component, in [0, 1], 0 below the threshold */
  rank: Float32Array;
}

export interface Curvature {
  /** |mean curvature| per vertex, 1 / unit */
  vertex: Float32Array;
  /** per triangle, the mean of its vertices */
  triangle: Float32Array;
}

/** In the order of `enum class Method` in wasm/simplify/simplify.h. */
export const METHODS = ['qem', 'paper', 'limber'] as const;
export type Method = (typeof METHODS)[number];

export const BORDERS = ['free', 'fixed'] as const;
/** The most values a wedge can have in SimplifyConstraints.attributes. */
export const ATTRIBUTE_LIMIT = 8;

/** What a simplification has to respect besides the surface; see wasm/simplify/constraints.h. Every list may be left out. */
export interface SimplifyConstraints {
  /** wedges[3 * t + corner]: equal at a vertex where all attributes are */
  wedges?: Uint32Array;
  /** per triangle: its primitive or material */
  groups?: Uint32Array;
  /** per vertex: not 0 where it may be neither moved nor removed */
  locked?: Uint8Array;
  /** per vertex, in [0, 1]: costs are multiplied by 1 + 99 keep */
  keep?: Float32Array;
  /** per vertex: bit k is set in the members of set k; survivors carry the sets, see MeshAt.inputOfVertex */
  pinnedSets?: Uint32Array;
  /** attributes[wedge * attributeDimension + i] (per vertex without wedges); 1 weighs as much as the bounding diagonal */
  attributes?: Float32Array;
  /** 1 to ATTRIBUTE_LIMIT */
  attributeDimension?: number;
  /** per vertex: its mirror image, itself on the plane of symmetry; both sides then collapse together */
  mirror?: Uint32Array;
  /** degrees; edges that bend more are creases; 0: none */
  creaseAngle?: number;
  borders?: (typeof BORDERS)[number];
}

export interface SimplifyOptions {
  method: Method;
  /** alpha of Eq. 11; w of limber */
  strainWeight: number;
  /** beta */
  curvatureWeight: number;
  /** gamma; g of limber */
  qualityWeight: number;
  /** s of limber; of an edge's squared length for qem */
  sizeWeight?: number;
  /** ends the history as soon as no more are left */
  stopFaces?: number;
  /** refuses collapses that take the surface farther from the input: a length in units of the mesh; 0: none */
  maxDeviation?: number;
  /** refuses collapses that make an angle smaller than this (degrees) where there was none; 0: none */
  minAngle?: number;
  constraints?: SimplifyConstraints;
}

/** Why the edges left at the end cannot collapse, each under its first reason; all 0 where the history ended at stopFaces. */
export interface Refused {
  topology: number;
  flip: number;
  lock: number;
  /** an angle below `minAngle` would come into being */
  angle: number;
  /** the surface would be farther than `maxDeviation` from the input */
  deviation: number;
}

/** Why a history ends, in the order of `enum class StopReason` in wasm/simplify/history.h. */
export const STOP_REASONS = ['target', 'deviation', 'angle', 'exhausted'] as const;

/** Every collapse down to its end. Collapse i moves vertex kept[i] to positions[3 * i + c] and takes in removed[i]. */
export interface History {
  vertexCount: number;
  triangleCount: number;
  kept: Uint32Array;
  removed: Uint32Array;
  positions: Float32Array;
  /** triangles left after collapse i, descending */
  trianglesAfter: Uint32Array;
  refused: Refused;
  /** why it ends */
  stop: (typeof STOP_REASONS)[number];
  /** SimplifyConstraints.mirror, where it was among the constraints: collapses then come in pairs */
  mirror?: Uint32Array;
}

/** The mirror symmetry of a mesh, or how far it is from one; see wasm/simplify/mirror_images.h. */
export interface MirrorImages {
  /** SimplifyConstraints.mirror; empty where there is no symmetry */
  partners: Uint32Array;
  /**
   * Per corner of the mesh with some quads cut the other way: which corner of the mesh it has been; empty where it is
   * symmetric as it stands, or not at all.
   */
  corners: Uint32Array;
  /** without an image */
  strayVertices: number;
  /** without an image, as the mesh stands, though their vertices have theirs */
  strayTriangles: number;
}

/** In the order of `enum class Verdict` in wasm/simplify/legality.h. */
export const VERDICTS = ['legal', 'lock', 'topology', 'flip', 'angle', 'deviation'] as const;

/**
 * What speaks for each vertex of a MeshAt: the terms of the cheapest collapse among its edges, legal ones first. The cost is
 * (error + size + strain + curvature + quality) * keep; see `struct CostTerms` in wasm/simplify/cost.h.
 */
export interface WhyKept {
  error: Float32Array;
  size: Float32Array;
  strain: Float32Array;
  curvature: Float32Array;
  quality: Float32Array;
  keep: Float32Array;
  /** the vertex at the other end, or 0xffffffff */
  neighbour: Uint32Array;
  /** an index of VERDICTS */
  verdict: Uint8Array;
}

/** Edges flipped after the history; both empty where there are none. */
export interface Flips {
  /** the triangles as the history left them */
  triangles: Uint32Array;
  /** per corner now: the corner (3 * t + c) of those that it has been */
  corners: Uint32Array;
}

export interface MeshAt {
  mesh: TriangleMesh;
  /** per input vertex: the vertex of `mesh` that it has become */
  vertexOfInput: Uint32Array;
  /** per vertex of `mesh`: the input vertex that has survived as it */
  inputOfVertex: Uint32Array;
  /** per triangle of `mesh`: which input triangle it is */
  inputOfTriangle: Uint32Array;
  flips: Flips;
}

export interface FitOptions {
  /** of the shell, in units of the mesh; half and twice as thick ones count too */
  thickness: number;
  poisson: number;
  charts: Charts;
  /** whether their seams stay in place; those of groups always do */
  holdsSeams: boolean;
  /** per input vertex: not 0 where it stays; may be empty */
  locked: Uint8Array;
  /** the same, and the modes of the body held there are fitted */
  pinned: Uint8Array;
  /** SimplifyConstraints.mirror: a result that is its own image stays one */
  mirror?: Uint32Array;
  /** what the result keeps, where it does so already: distance from `mesh`, in its units, and degrees; 0 sets no limit */
  maxDeviation: number;
  minAngle: number;
}

/** A result that vibrates like its original; frequency errors (root mean square, %) of each part that was fitted. */
export interface Fitted {
  result: MeshAt;
  errorBefore: Float64Array;
  errorAfter: Float64Array;
  /** components of more than 20,000 vertices, which are fitted at half and twice the thickness, in six rounds */
  large: number;
  /** such components that stay as they are: the original has more than 120,000 vertices there, or memory is short */
  tooLarge: number;
}

/** What parts a mesh into charts, over which no attribute may bleed. Both may be empty. */
export interface Charts {
  /** wedges[3 * t + corner]: equal at a vertex where all attributes are */
  wedges: Uint32Array;
  /** per triangle: what it is drawn with */
  groups: Uint32Array;
}

/** Where on the input the attributes of corner 3 * t + k of a result come from; see wasm/transfer/corner_sources.h. */
export interface CornerSources {
  /** a triangle of the input */
  triangle: Uint32Array;
  /** barycentric[3 * corner + c] on it */
  barycentric: Float32Array;
}

/** Where each vertex of the input lies on a result. */
export interface Binding {
  /** of the result, per input vertex; NONE where no triangle used it */
  triangle: Uint32Array;
  /** barycentric[3 * v + c] */
  barycentric: Float32Array;
  /** height above the triangle's plane, outwards, in units of the mesh */
  offset: Float32Array;
}

export interface Quality {
  /** degrees */
  minAngle: number;
  meanMinAngle: number;
  /** Eq. 9 */
  minQuality: number;
  meanQuality: number;
  /** triangles by smallest angle, 12 bins of 5 degrees */
  angleHistogram: Uint32Array;
}

/** In units of the mesh. */
export interface SurfaceDistance {
  hausdorff: number;
  mean: number;
  vertexHausdorff: number;
}

export interface FidelityOptions {
  modeCount: number;
  thickness: number;
  young: number;
  poisson: number;
  density: number;
  unit: number;
}

/** Errors in %; the keys of the report. */
export interface Fidelity {
  frequencyErrorMean: number;
  frequencyErrorMax: number;
  frequencyErrorCalibrated: number;
  calibrationFactor: number;
  frequencyErrorThin: number;
  frequencyErrorThick: number;
  frequencyErrorHigh: number;
  macMean: number;
  macMin: number;
}

/** The lowest elastic modes of a body's shell over all of its parts. */
export interface ShellModes {
  /** rad/s, ascending */
  omega: Float64Array;
  /** shapes[(k * vertexCount + v) * 3 + c] */
  shapes: Float32Array;
}

/** In the order of `enum class SimulationModel` in wasm/simulate/simulation.h. */
export const SIMULATION_MODELS = ['springs', 'shell'] as const;
/** shell: membrane and bending, the same material on any mesh; springs: the edges, as in the paper */
export type SimulationModel = (typeof SIMULATION_MODELS)[number];

/** A ball, where `from` is `to`, or a capsule; units of the mesh. */
export interface Collider {
  from: [number, number, number];
  to: [number, number, number];
  radius: number;
}

/** What a body can touch, in units of the mesh; it does not move. */
export interface CollisionScene {
  /** height of a floor across y */
  ground: number | null;
  colliders: Collider[];
}

export interface SimulationOptions extends Partial<CollisionScene> {
  material: SimulationModel;
  /** what happens; see wasm/simulate/scenario.h */
  scenario: ScenarioName;
  /** of the whole scenario */
  seconds: number;
  /** of a step of 1/60 s, 1 to 10,000 */
  substeps: number;
  /** 1/s: velocities fall by this rate */
  damping: number;
  /** sheets push each other away */
  selfCollision: boolean;
  /** Coulomb's coefficient, against all that the body touches */
  friction: number;
  /** Young's modulus of the optimized body over the original's, see calibrationFactor; left out: 1 */
  calibration?: number;
  /** vertices of the original; null: what the scenario itself holds */
  pinned: Uint32Array | null;
  /** in units of the mesh */
  thickness: number;
  /** Pa */
  young: number;
  poisson: number;
  /** kg/m3 */
  density: number;
  /** metres per unit of the mesh */
  unit: number;
}

export interface StartOptions extends SimulationOptions {
  /** where the original's vertices lie on this body, which its pins are carried over by; left out: by closest points */
  binding?: Pick<Binding, 'triangle' | 'barycentric'> | null;
  /** of the constraints: 0 as they come, any other number an order of its own */
  order?: number;
}

export interface ComparisonOptions {
  /** keep the positions of every step */
  records: boolean;
  /** where the original's vertices lie on the other body, which its pins are carried over by; null: by closest points */
  binding: Pick<Binding, 'triangle' | 'barycentric'> | null;
}

/** What one body has cost. */
export interface MotionRun {
  /** solved in a substep */
  constraints: number;
  /** of the mesh */
  edges: number;
  /** the shortest step, all work included */
  secondsPerStep: number;
  /** positions[(step * vertexCount + v) * 3 + c] after each step; empty unless `records` */
  positions: Float32Array;
}

/** How differently two bodies move, in % of the original's diagonal; see wasm/compare/motion_deviation.h. */
export interface MotionDeviation {
  mean: number;
  max: number;
}

/** How differently two bodies move in the same scenario, in % of the original's diagonal. */
export interface MotionComparison {
  original: MotionRun;
  /** null where there was no other body */
  other: MotionRun | null;
  /** over points of the surface and steps */
  deviationMean: number;
  deviationMax: number;
  /** the mean deviation of the original from itself with its constraints in another order */
  noiseFloor: number;
}

/** A point of a surface. */
export interface SurfacePoint {
  triangle: number;
  barycentric: [number, number, number];
}

/** In the order of `enum class Phase` in wasm/base/job.h. */
export const PHASES = [
  'idle',
  'welding vertices',
  'assembling matrices',
  'factorising',
  'solving for modes',
  'measuring strain',
  'measuring curvature',
  'collapsing edges',
  'measuring distance',
  'comparing modes',
  'fitting modes',
  'simulating',
  'looking for symmetry',
] as const;

/** Progress of the running call. `fraction` is of the phase, in [0, 1]. */
export interface Progress {
  phase: (typeof PHASES)[number];
  fraction: number;
}

/**
 * The core. Every function is synchronous and may run for long: call it off the main thread. All throw an Error with one
 * sentence; a cancelled call throws an Error whose name is 'Cancelled'.
 */
export interface Core {
  /** 1 in the one-thread build */
  threads: number;
  /**
   * The job's four words in shared memory ([0] cancel wish, [1] phase, [2] progress in 1/10,000): other threads read the
   * progress and set the wish while a call runs. null in the one-thread build, which has `onProgress` alone.
   */
  job: Int32Array | null;
  weld(positions: Float32Array, indices: Uint32Array, options: WeldOptions): WeldResult;
  inspect(mesh: TriangleMesh): Inspection;
  findModes(mesh: TriangleMesh, options: ModesOptions): ModeSet;
  strainGuidance(mesh: TriangleMesh, modes: ModeSet, options: GuidanceOptions): StrainGuidance;
  meanCurvature(mesh: TriangleMesh): Curvature;
  /** strain: rank per triangle; curvature: per vertex, over its maximum; empty arrays count as 0 */
  simplify(
    mesh: TriangleMesh,
    strain: Float32Array,
    curvature: Float32Array,
    options: SimplifyOptions,
  ): History;
  /** the largest mesh of the history with at most `faces` triangles */
  meshAt(mesh: TriangleMesh, history: History, faces: number): MeshAt;
  /** the result with its vertices moved a little and some edges flipped, so that it vibrates like `mesh` */
  fitModes(mesh: TriangleMesh, result: MeshAt, options: FitOptions): Fitted;
  /** the plane through the centre that a mesh is symmetric to: normal to axis 0, 1 or 2; -1: any that is found */
  findMirrorImages(mesh: TriangleMesh, charts: Charts, axis: number): MirrorImages;
  /** for every vertex of meshAt(mesh, history, faces), which must come from the same strain, curvature and options */
  whyKept(
    mesh: TriangleMesh,
    strain: Float32Array,
    curvature: Float32Array,
    options: SimplifyOptions,
    history: History,
    faces: number,
  ): WhyKept;
  /** where the attributes of a result's corners come from, without crossing a seam */
  sourceOfCorners(mesh: TriangleMesh, charts: Charts, result: MeshAt): CornerSources;
  /** every vertex of `mesh` on `result`, whose vertices may have moved since the history made it */
  bindToResult(mesh: TriangleMesh, result: MeshAt): Binding;
  measureQuality(mesh: TriangleMesh): Quality;
  measureSurfaceDistance(a: TriangleMesh, b: TriangleMesh): SurfaceDistance;
  compareFidelity(original: TriangleMesh, other: TriangleMesh, options: FidelityOptions): Fidelity;
  /** twice options.modeCount modes of the original, for frequencyErrors */
  shellModes(original: TriangleMesh, options: FidelityOptions): ShellModes;
  /** frequencyErrorMean and frequencyErrorMax of compareFidelity alone, in %: a sixth of its work */
  frequencyErrors(
    original: TriangleMesh,
    modes: ShellModes,
    other: TriangleMesh,
    options: FidelityOptions,
  ): { mean: number; max: number };
  /** that of compareFidelity alone, in a fraction of the time */
  calibrationFactor(original: TriangleMesh, other: TriangleMesh, options: FidelityOptions): number;
  /** the whole scenario, with the original alone or with both */
  compareMotion(
    original: TriangleMesh,
    other: TriangleMesh | null,
    options: SimulationOptions & ComparisonOptions,
  ): MotionComparison;
  /** all that a body can touch in this scenario: what the options add and what it has by itself */
  scenarioCollisionScene(original: TriangleMesh, options: SimulationOptions): CollisionScene;
  /** a number for the calls below; `mesh` is the original or a body that its pins are carried over to */
  startSimulation(mesh: TriangleMesh, original: TriangleMesh, options: StartOptions): number;
  /** one step of 1/60 s each, side by side; throws after it where a body has diverged, see simulationDiverged */
  stepSimulations(simulations: Uint32Array): null;
  /** positions[3 * v + c], in units of the mesh */
  simulationPositions(simulation: number): Float32Array;
  /** where the pins are now, [3 * pin + c]: pinned vertices, then pinned points of the surface */
  simulationPins(simulation: number): Float32Array;
  /** what the last step took on its thread, in seconds; 0 before the first */
  simulationSeconds(simulation: number): number;
  /** whether it has grown beyond ten times its size or is not finite; no step may follow */
  simulationDiverged(simulation: number): boolean;
  /** over 1,000 points of the surface, as they are now; both must have the same original, which is the first */
  simulationDeviation(original: number, other: number): MotionDeviation;
  /** draws a point of the surface towards `target` from now on */
  dragSimulation(simulation: number, point: SurfacePoint, target: [number, number, number]): null;
  releaseSimulation(simulation: number): null;
  /** frees its memory; every simulation that was started must be ended */
  endSimulation(simulation: number): null;
  /** the size of the wasm memory, which never shrinks */
  peakHeapBytes(): number;
}

export interface CoreOptions {
  /** 0: min(cores, 8); 1 loads the one-thread build */
  threads: number;
  /** the address of the folder that holds limber-threads.mjs and limber-single.mjs, with a final slash */
  wasmFolder: string;
  /** called on the calling thread in either build, at most once a percent */
  onProgress?: (progress: Progress) => void;
}
