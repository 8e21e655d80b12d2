/** Notes on the parts of an OBJ's materials that are left out of the document. */

import { counted } from '../../../core/words';
import { excerpt } from '../../text_scanner';

/** The most names that a note lists. */
const NAMES_SHOWN = 5;

/** A path that can lead out of a folder. */
const ELSEWHERE = /^([a-z]:|[/\\])|\.\./i;

interface Kind {
  one: string;
  several: string;
  /** what happens to it, why, and the cure */
  fate: string;
}

const KINDS = {
  missing: {
    one: 'texture',
    several: 'textures',
    fate: 'left out, missing or outside the folder: put the pictures beside the model',
  },
  format: {
    one: 'texture',
    several: 'textures',
    fate: 'left out, because glTF takes only PNG and JPEG: convert the pictures, and refer to the new ones in the material library',
  },
  heights: {
    one: 'bump map',
    several: 'bump maps',
    fate: 'left out, because glTF uses normals instead of heights: bake a normal map and refer to it by norm',
  },
  opacity: {
    one: 'map of opacity',
    several: 'maps of opacity',
    fate: 'left out, because glTF stores opacity in the colour picture: put it into the alpha channel of a PNG, and refer to that by map_Kd and map_d',
  },
  metal: {
    one: 'map of roughness or metalness',
    several: 'maps of roughness or metalness',
    fate: 'left out, because glTF stores both in one picture: put roughness into its green and metalness into its blue channel, and refer to it by map_Pr and map_Pm',
  },
  undefined: {
    one: 'material',
    several: 'materials',
    fate: 'plain, because no material library defines it',
  },
  library: {
    one: 'material library',
    several: 'material libraries',
    fate: 'left out, not text in UTF-8, or more than 8 MB: save it as UTF-8, or split it',
  },
} as const satisfies Record<string, Kind>;

export type OmissionKind = keyof typeof KINDS;

export class Omissions {
  private readonly names = new Map<OmissionKind, Set<string>>();
  private missingLibraries: string[] = [];

  add(kind: OmissionKind, name: string): void {
    if (!this.names.has(kind)) this.names.set(kind, new Set());
    this.names.get(kind)!.add(name);
  }

  /** Adds missing libraries that may define materials found nowhere else. */
  addMissingLibraries(names: string[]): void {
    this.missingLibraries = names;
  }

  notes(): string[] {
    const others = [...this.names].map(([kind, names]) => describe(KINDS[kind], [...names]));
    return this.missingLibraries.length > 0 ? [describeMissing(this.missingLibraries), ...others] : others;
  }
}

const describe = ({ one, several, fate }: Kind, names: string[]): string =>
  `${counted(names.length, one, several)} (${listed(names)}) ${fate}`;

function describeMissing(names: string[]): string {
  const [are, them] = names.length === 1 ? ['is', 'it'] : ['are', 'them'];
  const where = names.some((name) => ELSEWHERE.test(name)) ? 'missing or outside its folder' : 'missing';
  return `${listed(names)} ${are} ${where}: put ${them} beside the OBJ to get the colours and textures of its materials`;
}

function listed(names: string[]): string {
  const more = names.length > NAMES_SHOWN ? ` and ${names.length - NAMES_SHOWN} more` : '';
  return names.slice(0, NAMES_SHOWN).map(excerpt).join(', ') + more;
}
