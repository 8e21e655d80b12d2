/** The material of the settings on one body. */

import type { Settings } from '../settings/options';
import type { BodySize } from './prepared_body';

/** The settings that make up a material, with the unit of the file. */
export const MATERIAL_SETTINGS = ['young', 'poisson', 'density', 'thickness', 'unit'] as const;

export type MaterialSettings = Pick<Settings, (typeof MATERIAL_SETTINGS)[number]>;

/** What parameters of engines follow from where they are not given. */
export const ENGINE_MATERIAL = ['young', 'poisson', 'density', 'thickness', 'bendRatio'] as const;

export type EngineMaterial = Pick<Settings, (typeof ENGINE_MATERIAL)[number]>;

/** The material on this body: thickness in units of its mesh, `unit` in metres per such unit. */
export function materialOf(size: BodySize, settings: MaterialSettings) {
  const { young, poisson, density, unit } = settings;
  return { young, poisson, density, thickness: thicknessOf(size, settings), unit: unit * size.body.scale };
}

/** In units of the mesh. */
export const thicknessOf = (
  { diagonal }: Pick<BodySize, 'diagonal'>,
  { thickness }: Pick<Settings, 'thickness'>,
): number => (thickness / 100) * diagonal;
