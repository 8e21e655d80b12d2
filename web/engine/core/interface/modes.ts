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
  /** laplacian: axis of motion, 0 x, 1 y, 2 z; -1: every mode once along each principal axis */
  direction: number;
  /** ids of pinned vertices, ascending */
  pinned: Uint32Array;
  /** false: shells of more than 8,000 vertices are solved on a decimated copy and then refined */
  exact: boolean;
  /** elastic modes per component */
  modeCount: number;
  /** where modes are needed for guidance alone: the number of bodies in the file; parts of many are solved more coarsely */
  guidedParts?: number;
}

/** One elastic mode of one component. */
export interface Mode {
  /** rad/s */
  omega: number;
  /** |K phi - lambda M phi| / (lambda |M phi|) */
  residual: number;
  component: number;
  /** the mode is the (ordinal + 1)-th elastic mode of its component */
  ordinal: number;
  /** laplacian: the principal axis of motion, 0 shortest .. 2 longest; otherwise -1 */
  axis: number;
  name: ModeName;
}

export interface ComponentModes {
  faces: number;
  model: Model;
  /** the component whose modes it shares: the solid around a cavity, otherwise itself */
  host: number;
  /** vertices of the coarse copy that was solved in its place; 0 if it was solved itself */
  coarseVertices: number;
  zeroModesExpected: number;
  zeroModesFound: number;
  modeCount: number;
  /** why it has no modes, in a sentence; '' where it has been solved. Only with `guidedParts` */
  failure?: string;
}

/** Modes of all components. At each vertex, ordinal k is the (k + 1)-th elastic mode of the vertex's own component. */
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
  /** ordinals of the guiding modes, from 0 */
  ordinals: number[];
  /** per entry of `ordinals`: w_k of Eq. 6; if empty, 1 / omega_k^2 */
  weights: number[];
  /** exponent of the norm that combines modes, in [1, Infinity] */
  p: number;
  /** ranks below this count as 0; in [0, 1] */
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
