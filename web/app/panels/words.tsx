/** The terms of the page: each explained in a sentence for an artist, and one for an engineer. */

import { say } from '../language/say';

const WORDS: [word: string, plain: string, exact: string][] = [
  [
    'Mode',
    'A way in which the model bends or twists easily.',
    'A solution of K phi = omega² M phi, without the rigid motions.',
  ],
  ['Frequency', 'How fast it swings in that way.', 'omega / 2 pi in Hz, for the unit and material given.'],
  [
    'Strain',
    'Where the surface is stretched when it moves.',
    'Norm of the Green-Lagrange strain of the mode shape, ranked 0 to 1.',
  ],
  [
    'Deviation',
    'How far the new surface is from the old one where they differ most.',
    'Hausdorff distance both ways, in % of the diagonal.',
  ],
  [
    'Smallest angle',
    'How thin the thinnest triangle is.',
    'Of all corners, in degrees; thin triangles make simulations stiff.',
  ],
  [
    'Topology',
    'Parts, holes and open borders: these do not change.',
    'Components, genus and boundary loops, certified after every run.',
  ],
  [
    'Seam',
    'Where the texture is cut; both sides stay together.',
    'An edge at which the attributes of its two triangles differ.',
  ],
  ['Pinned', 'Held in place.', 'Vertices without degrees of freedom, in modes and simulations.'],
  [
    'Fit',
    'After faces are removed, vertices are moved a little to restore the shape.',
    'Least squares distance to the original under limits, or residuals of frequencies.',
  ],
  [
    'Tuned',
    'The numbers for your engine with which the new mesh moves like the old one.',
    'Factors on stretching and bending and masses per vertex.',
  ],
  [
    'Noise floor',
    'How much the original differs from itself when computed in another way: smaller differences mean nothing.',
    'The original simulated with its constraints in another order.',
  ],
];

export function Words() {
  return (
    <dl class="words">
      {WORDS.map(([word, plain, exact]) => (
        <div key={word}>
          <dt>{say(word)}</dt>
          <dd>
            {say(plain)}
            <details>
              <summary>{say('exactly')}</summary>
              {say(exact)}
            </details>
          </dd>
        </div>
      ))}
    </dl>
  );
}
