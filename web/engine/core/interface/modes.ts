/** Modes of vibration, and the guidance that follows from them. */

import type { ElasticMaterial } from './material';
import type { MeshInput } from './mesh';

/** In the order of `enum class Model` in wasm/elastic/modes.h, which ends with `auto`. */
export const MODELS = ['laplacian', 'shell', 'solid'] as const;

export type Model = (typeof MODELS)[number];

/** `local`: little of the surface takes part; see wasm/elastic/mode_character.h for the rule. */
export const MODE_NAMES = ['bend', 'twist', 'stretch', 'breathe', 'local'] as const;

export type ModeName = (typeof MODE_NAMES)[number];

export interface ModesOptions extends ElasticMaterial {
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

/** The functions of the core on this topic. */
export interface ModesFunctions {
  findModes(mesh: MeshInput, options: ModesOptions): ModeSet;
  strainGuidance(mesh: MeshInput, modes: ModeSet, options: GuidanceOptions): StrainGuidance;
}
