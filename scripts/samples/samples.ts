// The samples that ship with the product.

import { makeBar } from './bar';
import { makeCloth } from './cloth/cloth';
import { makeOrganic } from './organic/organic';
import type { Shape } from './shape';
import { makeTower } from './tower/tower';

export interface Sample {
  id: string;
  name: string;
  /** One short line for a card. */
  about: string;
  /** Linear RGB of the base colour. */
  colour: readonly [number, number, number];
  roughness: number;
  /** Whether both sides of the surface are visible. */
  isOpen: boolean;
  /** Edges with a larger angle, degrees, are shaded as creases; 180: none are. */
  creaseDegrees: number;
  make: () => Shape;
}

export const samples: readonly Sample[] = [
  {
    id: 'bar',
    name: 'Bar',
    about: "The paper's bar of 8 x 8 x 24 cells, the simplest thing that bends.",
    colour: [0.62, 0.35, 0.16],
    roughness: 0.6,
    isOpen: false,
    creaseDegrees: 40,
    make: makeBar,
  },
  {
    id: 'cloth',
    name: 'Hanging cloth',
    about: 'A square of cotton at rest, hung by two corners.',
    colour: [0.47, 0.1, 0.13],
    roughness: 0.85,
    isOpen: true,
    creaseDegrees: 180,
    make: makeCloth,
  },
  {
    id: 'tower',
    name: 'Lattice tower',
    about: 'Struts, arches and platforms, with hundreds of openings.',
    colour: [0.17, 0.105, 0.07],
    roughness: 0.5,
    isOpen: false,
    creaseDegrees: 40,
    make: makeTower,
  },
  {
    id: 'organic',
    name: 'Organic shape',
    about: 'A smooth sculpture of limbs that melt together around its holes.',
    colour: [0.58, 0.55, 0.47],
    roughness: 0.45,
    isOpen: false,
    creaseDegrees: 180,
    make: makeOrganic,
  },
];
