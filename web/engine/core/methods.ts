/**
 * The only list of simplification methods in TypeScript, with the properties of each. Each row has a cost policy of the
 * same name in `wasm/simplify/cost`, with a row in `policies.h` there; a new method needs these and nothing else.
 */

import type { Model } from './interface/modes';

interface MethodRow {
  name: string;
  label: string;
  /** what guides the collapses, as a sentence without its end */
  title: string;
  /** the same as an aside in a help text */
  aside: string;
  /** settings whose default for this method differs from the table of settings */
  defaults: Readonly<Record<string, number>>;
  /** settings that this method reads and at least one other does not */
  reads: readonly string[];
  /** whether the strain of the guiding modes enters the cost of a collapse, so that modes are found first */
  needsGuidance: boolean;
  /** whether curvature enters the cost of a collapse */
  needsCurvature: boolean;
  /** whether the result can be fitted to the original: to its surface or its modes */
  canFit: boolean;
  /** whether collapses that are estimated to deviate farther than a limit are deferred until no other is left */
  defersDeviation: boolean;
  /** whether seams and borders of materials stay closed and attributes enter the cost of a collapse */
  keepsAttributes: boolean;
  /** the elastic model that `auto` stands for */
  autoModel: 'auto' | Model;
  /** the number of guiding modes that `auto` stands for */
  autoModes: number;
}

export const METHODS = [
  {
    name: 'limber',
    label: 'Motion',
    title: 'Shape, triangle sizes and strain guide the collapses; then the result is fitted to the surface',
    aside: 'shape, size, quality and strain, followed by a fit to the surface',
    defaults: {},
    reads: ['strainWeight', 'qualityWeight', 'sizeWeight', 'fit', 'seams'],
    needsGuidance: true,
    needsCurvature: false,
    canFit: true,
    defersDeviation: true,
    keepsAttributes: true,
    autoModel: 'auto',
    autoModes: 6,
  },
  /** the method as printed: Eq. 11, guided by the first mode of the Laplacian */
  {
    name: 'paper',
    label: 'Paper',
    title: 'Strain, curvature and triangle shape guide the collapses (Eq. 11 of the paper)',
    aside: 'strain, curvature and shape, Eq. 11',
    defaults: { strainWeight: 0.05, curvatureWeight: 1, qualityWeight: 0.01, sizeWeight: 0 },
    reads: ['strainWeight', 'curvatureWeight', 'qualityWeight'],
    needsGuidance: true,
    needsCurvature: true,
    canFit: false,
    defersDeviation: false,
    keepsAttributes: false,
    autoModel: 'laplacian',
    autoModes: 1,
  },
  {
    name: 'qem',
    label: 'Shape only',
    title: 'Area-weighted quadrics only',
    aside: 'area-weighted quadrics only',
    defaults: { sizeWeight: 0 },
    reads: ['sizeWeight', 'seams'],
    needsGuidance: false,
    needsCurvature: false,
    canFit: false,
    defersDeviation: false,
    keepsAttributes: true,
    autoModel: 'auto',
    autoModes: 6,
  },
] as const satisfies readonly MethodRow[];

export type Method = (typeof METHODS)[number]['name'];

export const METHOD_NAMES: readonly Method[] = METHODS.map(({ name }) => name);

/** All methods with their asides, as an enumeration: "limber (...), paper (...) or qem (...)". */
export function describeMethods(): string {
  const words = METHODS.map(({ name, aside }) => `${name} (${aside})`);
  return `${words.slice(0, -1).join(', ')} or ${words.at(-1)}`;
}
