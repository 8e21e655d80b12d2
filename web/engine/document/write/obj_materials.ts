/** The material library of a written OBJ: glTF's materials as far as MTL can express them, with its PBR extension (Pr, Pm, norm). */

import type { Material, Texture } from '@gltf-transform/core';
import type { SourceFile } from '../model';
import { shortest } from './text_values';

const NONE = 'none';

export class MaterialLibrary {
  private readonly names = new Map<Material | null, string>();
  private readonly shown = new Set<Texture>();

  /** `imageNames`: the file of each texture. `isKept`: names stay, as libraries of the input say what they look like. */
  constructor(
    private readonly imageNames: Map<Texture, string>,
    private readonly isKept: boolean,
  ) {}

  /** Whether no material has been named yet. */
  get isEmpty(): boolean {
    return this.names.size === 0;
  }

  /** The unique name of a material; with `isKept` its own name. */
  nameOf(material: Material | null): string {
    const known = this.names.get(material);
    if (known !== undefined) return known;
    const plain = material
      ? material
          .getName()
          .replaceAll(/[\r\n]+/g, ' ')
          .trim() || 'material'
      : NONE;
    const taken = new Set(this.names.values());
    let free = plain;
    for (let number = 2; !this.isKept && taken.has(free); ++number) free = `${plain} ${number}`;
    this.names.set(material, free);
    return free;
  }

  /** The text of the library with all materials that have been named so far. */
  text(mark: string): string {
    const blocks = [...this.names].map(([material, name]) =>
      [`newmtl ${name}`, ...(material ? this.linesOf(material) : [])].join('\n'),
    );
    return `# ${mark}\n\n${blocks.join('\n\n')}\n`;
  }

  /** The pictures that the text names; each file once. */
  pictures(): SourceFile[] {
    const files = new Map<string, Uint8Array>();
    for (const texture of this.shown) {
      const bytes = texture.getImage();
      if (bytes) files.set(this.imageNames.get(texture)!, bytes);
    }
    return [...files].map(([name, bytes]) => ({ name, bytes }));
  }

  private linesOf(material: Material): string[] {
    const [red, green, blue, alpha] = material.getBaseColorFactor();
    const emissive = material.getEmissiveFactor();
    const roughness = material.getRoughnessFactor();
    return [
      `Kd ${[red, green, blue].map(shortest).join(' ')}`,
      ...(emissive.some((value) => value > 0) ? [`Ke ${emissive.map(shortest).join(' ')}`] : []),
      // As Blender converts one to the other.
      `Ns ${shortest(1000 * (1 - roughness) ** 2)}`,
      `d ${shortest(material.getAlphaMode() === 'OPAQUE' ? 1 : alpha)}`,
      `Pr ${shortest(roughness)}`,
      `Pm ${shortest(material.getMetallicFactor())}`,
      ...this.map('map_Kd', material.getBaseColorTexture()),
      ...this.map('map_Ke', material.getEmissiveTexture()),
      ...this.map('norm', material.getNormalTexture()),
    ];
  }

  private map(keyword: string, texture: Texture | null): string[] {
    if (!texture) return [];
    this.shown.add(texture);
    return [`${keyword} ${this.imageNames.get(texture) ?? texture.getURI()}`];
  }
}
