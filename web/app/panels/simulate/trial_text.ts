/** The verdict of a short motion trial on the tuned numbers. */

import type { TunedMotion } from '../../../engine/core/core';
import { percent } from '../../controls/numbers';
import { listed, say } from '../../language/say';

/** By the scenes that are tried, see web/engine/core/interface/tune.ts. */
const TRIED: Record<string, string> = { sway: 'how it sways', hang: 'how it hangs' };

/** A sentence that names the motions of the trial, because the shown scenario may be different, with both deviations. */
export function describeTrial({ scene, kept, noiseFloor, ...deviations }: TunedMotion): string {
  const words = {
    tried: listed(scene.split(' and ').map((name) => say(TRIED[name] ?? name))),
    tuned: percent(deviations.tuned),
    untouched: percent(deviations.untouched),
    noise: percent(noiseFloor),
  };
  if (kept === 'untouched')
    return say(
      "In a trial of {tried}, it was {untouched} of the diagonal away with the original's stiffness and {tuned} with another, so only the masses are tuned. Other motions may differ.",
      words,
    );
  return deviations.tuned < deviations.untouched
    ? say(
        'In a trial of {tried}, it was {tuned} of the diagonal away tuned and {untouched} untuned. Other motions may differ.',
        words,
      )
    : say(
        'In a trial of {tried}, it was {tuned} of the diagonal away tuned and {untouched} untuned, no further apart than the noise of {noise}. Other motions may differ.',
        words,
      );
}
