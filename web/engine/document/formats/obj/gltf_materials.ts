/** Converts MTL materials to glTF materials. docs/formats.md has the rules where the two differ, with their sources. */

import type { Material, Texture } from '@gltf-transform/core';
import type { Omissions } from './omissions';
import type { FoundMaterial } from './libraries';
import type { MtlMaterial, Rgb } from './mtl';
import type { MtlMap } from './mtl_map';
import { hasAlpha } from './pictures';
import type { Pictures } from './pictures';

/** The largest specular exponent. */
const MAX_EXPONENT = 1000;

const WHITE: Rgb = [1, 1, 1];

/** Keywords of maps by their use; the first one that a material has is taken. */
const MAPS = {
  colour: ['map_kd'],
  opacity: ['map_d'],
  emission: ['map_ke', 'map_emissive'],
  normals: ['norm', 'map_kn'],
  bumps: ['map_bump', 'bump'],
  roughness: ['map_pr'],
  metalness: ['map_pm'],
} as const;

type MapUse = keyof typeof MAPS;

/** Keywords of all maps that are used. */
export const READ_MAPS: readonly string[] = Object.values(MAPS).flat();

/** Whether the material has a map that is used. */
export const hasMaps = ({ material }: FoundMaterial): boolean =>
  READ_MAPS.some((keyword) => material.maps.has(keyword));

/** File names of normal maps that a library declares as bump maps, as Blender does. */
const NORMAL_NAME = /normal|(^|[^a-z])(norm|nrm|nor)([^a-z]|$)|_n$/i;

/** A texture that was found, and how it is mapped to the surface. */
interface FoundMap {
  texture: Texture;
  map: MtlMap;
}

/** Looks for the picture of a use. */
type Find = (use: MapUse) => FoundMap | null;

/** Sets the properties of a plain material from MTL. `hasUvs`: whether its surface has UVs, which textures need. */
export function applyMtl(
  material: Material,
  { material: mtl, library }: FoundMaterial,
  { hasUvs, ...context }: { pictures: Pictures; omissions: Omissions; hasUvs: boolean },
): void {
  const find: Find = (use) => {
    const map = hasUvs ? mapOf(mtl, use) : null;
    const texture = map && context.pictures.textureOf(library, map.name);
    return texture ? { texture, map } : null;
  };
  setBaseColour(material, mtl, { find, ...context });
  setMetallicRoughness(material, mtl, { find, ...context });
  setEmission(material, mtl, { find, ...context });
  setNormalMap(material, { find, ...context });
}

const mapOf = (mtl: MtlMaterial, use: MapUse): MtlMap | null =>
  MAPS[use].map((keyword) => mtl.maps.get(keyword)).find((map) => map !== undefined) ?? null;

interface Context {
  find: Find;
  pictures: Pictures;
  omissions: Omissions;
}

function setBaseColour(material: Material, mtl: MtlMaterial, { find, pictures, omissions }: Context): void {
  const colour = find('colour');
  const [red, green, blue] = tintOf(mtl.colours.get('kd') ?? WHITE, colour !== null);
  const alpha = opacityOf(mtl);
  material.setBaseColorFactor([red, green, blue, alpha]);
  if (colour) {
    material.setBaseColorTexture(colour.texture);
    pictures.lay(material.getBaseColorTextureInfo()!, colour.map);
  }
  const opacity = find('opacity');
  const isInColour = opacity !== null && opacity.texture === colour?.texture && hasAlpha(opacity.texture);
  if (opacity && !isInColour) omissions.add('opacity', opacity.map.name);
  if (alpha < 1 || isInColour) material.setAlphaMode('BLEND');
}

/** A grey colour beside a map is a leftover of the exporting program, and would make many maps dark or black. */
function tintOf(colour: Rgb, isTextured: boolean): Rgb {
  const [red, green, blue] = colour;
  return isTextured && red === green && green === blue ? WHITE : (colour.map(toUnit) as Rgb);
}

/** The opacity. A value of 0 comes from programs that swap opacity and transparency. */
function opacityOf({ numbers }: MtlMaterial): number {
  const opacity = toUnit(numbers.get('d') ?? 1 - (numbers.get('tr') ?? 0));
  return opacity === 0 ? 1 : opacity;
}

const toUnit = (value: number): number => Math.min(1, Math.max(0, value));

function setMetallicRoughness(
  material: Material,
  mtl: MtlMaterial,
  { find, pictures, omissions }: Context,
): void {
  const [roughness, metalness] = [find('roughness'), find('metalness')];
  const metallic = toUnit(mtl.numbers.get('pm') ?? 0);
  const isPacked = roughness !== null && roughness.texture === metalness?.texture;
  // In a grey map the green channel is the roughness; the blue one has no effect where the metallic factor is 0.
  if (roughness && (isPacked || (!metalness && metallic === 0))) {
    material.setMetallicRoughnessTexture(roughness.texture);
    pictures.lay(material.getMetallicRoughnessTextureInfo()!, roughness.map);
    material.setRoughnessFactor(1).setMetallicFactor(isPacked ? 1 : 0);
    return;
  }
  for (const shown of [roughness, metalness]) if (shown) omissions.add('metal', shown.map.name);
  material.setRoughnessFactor(roughnessOf(mtl)).setMetallicFactor(metallic);
}

/** The file's roughness, or Blender's formula: a specular exponent of 1,000 is a mirror. */
function roughnessOf({ numbers, colours }: MtlMaterial): number {
  const own = numbers.get('pr');
  if (own !== undefined) return toUnit(own);
  const hasHighlights =
    (numbers.get('illum') ?? 2) > 1 && (colours.get('ks') ?? WHITE).some((value) => value > 0);
  const exponent = hasHighlights ? (numbers.get('ns') ?? 0) : 0;
  return 1 - Math.sqrt(toUnit(exponent / MAX_EXPONENT));
}

/** Emission above 1 is scaled down, which keeps its hue. */
function setEmission(material: Material, { colours }: MtlMaterial, { find, pictures }: Context): void {
  const shown = find('emission');
  const own = colours.get('ke') ?? [0, 0, 0];
  const colour = shown && own.every((value) => value === 0) ? WHITE : own;
  const most = Math.max(1, ...colour);
  material.setEmissiveFactor(colour.map((value) => value / most) as Rgb);
  if (!shown) return;
  material.setEmissiveTexture(shown.texture);
  pictures.lay(material.getEmissiveTextureInfo()!, shown.map);
}

function setNormalMap(material: Material, context: Context): void {
  const shown = context.find('normals') ?? normalsAmongBumps(context);
  if (!shown) return;
  material.setNormalTexture(shown.texture).setNormalScale(shown.map.strength);
  context.pictures.lay(material.getNormalTextureInfo()!, shown.map);
}

/** A bump map whose name says that it is a normal map. */
function normalsAmongBumps({ find, omissions }: Context): FoundMap | null {
  const shown = find('bumps');
  if (!shown) return null;
  const stem = shown.map.name.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
  if (NORMAL_NAME.test(stem)) return shown;
  omissions.add('heights', shown.map.name);
  return null;
}
