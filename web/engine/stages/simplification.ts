/** The core's options of a simplification, from the settings that have an effect with the method. */

import type { BodyConstraints } from '../body/constraints';
import type { CostAttributes } from '../body/cost_attributes';
import type { PreparedBody } from '../body/prepared_body';
import { maskOf } from '../body/vertex_mask';
import type { Curvature, SimplifyConstraints, SimplifyOptions, StrainGuidance } from '../core/core';
import { methodOf, OPTIONS, readsSetting } from '../settings/options';
import type { Settings } from '../settings/options';

const WEIGHTS = ['strainWeight', 'curvatureWeight', 'qualityWeight', 'sizeWeight'] as const;

export const SIMPLIFICATION_SETTINGS = [
  'method',
  ...WEIGHTS,
  'maxDeviation',
  'minAngle',
  'borders',
  'seams',
  'creases',
] as const;

type AllSettings = Pick<Settings, (typeof SIMPLIFICATION_SETTINGS)[number]>;

export interface SimplificationSettings extends Omit<AllSettings, 'seams'> {
  /** null: the method ignores attributes */
  seams: Settings['seams'] | null;
}

/** The settings that have an effect with their method: weights that its costs lack are 0. */
export function simplificationSettings(settings: AllSettings): SimplificationSettings {
  const weight = (name: (typeof WEIGHTS)[number]): number =>
    readsSetting(settings, name) ? settings[name] : 0;
  return {
    ...settings,
    strainWeight: weight('strainWeight'),
    curvatureWeight: weight('curvatureWeight'),
    qualityWeight: weight('qualityWeight'),
    sizeWeight: weight('sizeWeight'),
    seams: methodOf(settings).keepsAttributes ? settings.seams : null,
  };
}

/** The guides of collapses besides the settings; null: the method has no such term. */
export interface Guides {
  constraints: BodyConstraints;
  /** null: they cost nothing */
  costs: CostAttributes | null;
  guidance: StrainGuidance | null;
  curvature: Curvature | null;
}

export interface Simplification {
  /** rank per triangle; empty: 0 everywhere */
  strain: Float32Array;
  /** per vertex, over its maximum; empty: 0 everywhere */
  curvature: Float32Array;
  options: SimplifyOptions;
}

export function simplificationOf(
  prepared: PreparedBody,
  { constraints, costs, guidance, curvature }: Guides,
  settings: SimplificationSettings,
): Simplification {
  const { method, strainWeight, curvatureWeight, qualityWeight, sizeWeight, minAngle } = settings;
  const weights = { strainWeight, curvatureWeight, qualityWeight, sizeWeight };
  const deferredDeviation = settings.maxDeviation > 0 ? settings.maxDeviation : OPTIONS.maxDeviation.default;
  return {
    strain: guidance?.rank ?? new Float32Array(0),
    curvature: curvature ? overMaximum(curvature.vertex) : new Float32Array(0),
    options: {
      method,
      ...weights,
      minAngle,
      recordErrors: true,
      deferBeyond: methodOf(settings).defersDeviation ? (deferredDeviation / 100) * prepared.diagonal : 0,
      constraints: simplifyConstraints(prepared, settings, { constraints, costs }),
    },
  };
}

/**
 * The paper's method ignores attributes. For the others, borders of materials stay closed and where they
 * are; unless seams are to be crossed, so do seams, and attributes cost.
 */
function simplifyConstraints(
  prepared: PreparedBody,
  { borders, seams, creases }: SimplificationSettings,
  { constraints: { pinned, locked, keep, mirror }, costs }: Pick<Guides, 'constraints' | 'costs'>,
): SimplifyConstraints {
  const pins = maskOf(prepared.mesh, pinned);
  const constraints = {
    pinnedSets: pins && Uint32Array.from(pins),
    locked: maskOf(prepared.mesh, locked),
    keep,
    mirror,
    creaseAngle: creases,
    borders,
  };
  if (seams === null) return constraints;
  const { charts } = prepared.attributes;
  if (seams === 'cross') return { ...constraints, groups: charts.groups };
  if (!costs) return { ...constraints, ...charts };
  const { values, dimension, displacementFields, textureWeights } = costs;
  const charged = { attributes: values, attributeDimension: dimension, displacementFields, textureWeights };
  return { ...constraints, ...charts, ...charged };
}

function overMaximum(field: Float32Array): Float32Array {
  const maximum = field.reduce((largest, value) => Math.max(largest, value), 0);
  return maximum > 0 ? field.map((value) => value / maximum) : field;
}
