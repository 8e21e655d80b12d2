/** What the Test step says of the trial of a tuned motion. */

import { expect, it, vi } from 'vitest';
import { describeTrial } from '../../web/app/panels/simulate/trial_text';

vi.hoisted(() => vi.stubGlobal('navigator', { languages: ['en'] }));

const motion = { scene: 'hang', untouched: 2, tuned: 1, noiseFloor: 0, kept: 'tuned' } as const;

it('the motion that was tried is named with both deviations, whichever numbers it spoke for', () => {
  expect(describeTrial(motion)).toBe(
    'In a trial of how it hangs, it was 1.00 % of the diagonal away tuned and 2.00 % untuned. Other motions may differ.',
  );
  expect(describeTrial({ ...motion, scene: 'sway and hang', tuned: 3, kept: 'untouched' })).toBe(
    "In a trial of how it sways and how it hangs, it was 2.00 % of the diagonal away with the original's stiffness and 3.00 % with another, so only the masses are tuned. Other motions may differ.",
  );
});

it('a difference within the noise is told as one', () => {
  expect(describeTrial({ ...motion, tuned: 2.5, noiseFloor: 0.75 })).toBe(
    'In a trial of how it hangs, it was 2.50 % of the diagonal away tuned and 2.00 % untuned, no further apart than the noise of 0.75 %. Other motions may differ.',
  );
});
