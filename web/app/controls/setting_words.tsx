/** The explanation of a setting behind a button: a plain sentence, and an exact one. */

import type { ComponentChildren } from 'preact';
import { useId, useState } from 'preact/hooks';
import { OPTIONS } from '../../engine/settings/options';
import type { SettingName } from '../../engine/settings/options';
import './setting_words.css';
import { say } from '../language/say';

/** Without terms of mechanics; the exact sentence is the help of the table of settings. */
const PLAIN: Partial<Record<SettingName, string>> = {
  strainWeight: 'More keeps faces where the surface stretches and folds when it moves.',
  curvatureWeight: 'More keeps faces where the shape is round or sharp.',
  qualityWeight: 'More avoids long thin triangles.',
  sizeWeight: 'More makes triangles of about one size.',
  maxDeviation: 'The new surface never leaves the old one by more than this.',
  minAngle: 'No triangle becomes thinner than this.',
  maxFrequencyError: 'How far its frequencies may differ from those of the original.',
  creases: 'Edges sharper than this stay where they are.',
  fit: 'At the end, vertices move a little to restore the shape.',
  modeCount: 'How many ways of bending and twisting are computed.',
  p: 'High: each spot counts by its worst motion. Low: by all motions together.',
  strainThreshold: 'Spots that hardly stretch count as if they did not stretch at all.',
  young: 'How hard it is to stretch: rubber is soft, paper is stiff.',
  poisson: 'How much it gets thinner when it is pulled longer.',
  density: 'How heavy it is: heavier things swing slower.',
  thickness: 'How thick the sheet is: thicker ones bend less.',
  seconds: 'How long the motion is.',
  damping: 'How soon it comes to rest.',
  selfCollision: 'It cannot pass through itself.',
  friction: 'How well it grips what it touches.',
  calibrate: 'One factor on the stiffness makes the new mesh swing as fast as the old one.',
};

/** The elements that `useSettingWords` returns: a button for next to the label, and the sentences, which are null while they are closed. */
export interface SettingWords {
  button: ComponentChildren;
  sentences: ComponentChildren;
}

/** For a setting without a plain sentence both are null. */
export function useSettingWords(name: SettingName): SettingWords {
  const [isOpen, setOpen] = useState(false);
  const id = useId();
  const plain = PLAIN[name];
  if (!plain) return { button: null, sentences: null };
  return {
    button: (
      <button
        type="button"
        class="quiet about"
        aria-label={say('What it does')}
        title={say(OPTIONS[name].label)}
        aria-expanded={isOpen}
        aria-controls={isOpen ? id : undefined}
        onClick={() => setOpen(!isOpen)}
      >
        i
      </button>
    ),
    sentences: isOpen && (
      <div class="about-words" id={id}>
        <p>{say(plain)}</p>
        <p class="muted">{say('Exactly: {sentence}', { sentence: say(OPTIONS[name].help) })}</p>
      </div>
    ),
  };
}
