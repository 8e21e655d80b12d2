/** Named materials, with typical values: a piece of real cloth or leather may differ much from them. */

import type { Settings } from './table';

export type Material = Pick<Settings, 'young' | 'poisson' | 'density' | 'thickness'>;

export const MATERIALS = {
  /** soft rubber, a solid toy or a thick sheet */
  rubber: { young: 1e6, poisson: 0.3, density: 1000, thickness: 2 },
  /** open-cell upholstery foam */
  foam: { young: 5e4, poisson: 0.2, density: 30, thickness: 4 },
  /** plain-woven shirt cotton, 0.15 kg/m2; the thickness is that on a garment of 1.5 m */
  cotton: { young: 2e7, poisson: 0.2, density: 400, thickness: 0.03 },
  /** dress silk */
  silk: { young: 4e7, poisson: 0.25, density: 450, thickness: 0.01 },
  /** upper leather */
  leather: { young: 5e7, poisson: 0.35, density: 860, thickness: 0.15 },
  /** office paper, 80 g/m2 on A4 */
  paper: { young: 3e9, poisson: 0.3, density: 800, thickness: 0.03 },
} as const satisfies Record<string, Material>;

export type MaterialName = keyof typeof MATERIALS;

export const MATERIAL_NAMES = Object.keys(MATERIALS) as MaterialName[];

/** The name of the settings' material; null where the numbers are those of no named one. */
export function materialNameOf(settings: Settings): MaterialName | null {
  const isSame = (name: MaterialName) =>
    Object.entries(MATERIALS[name]).every(([key, value]) => settings[key as keyof Material] === value);
  return MATERIAL_NAMES.find(isSame) ?? null;
}
