/** Says which part vibrates most differently from the original, and offers what helps. */

import { count, fixed } from '../../controls/numbers';
import { changeSettings, keepFaces, results, shownFit, slider } from '../../state/store';

/** Errors below this, in %, are not worth a remark. */
const LARGE = 5;
const MORE_FACES = 1.25;

/** The part with the largest frequency error after the fit; `error` in %. */
export function worstPart(errors: Float64Array): { part: number; error: number } | null {
  let worst: { part: number; error: number } | null = null;
  errors.forEach((error, part) => {
    if (!worst || error > worst.error) worst = { part, error };
  });
  return worst;
}

/** "part 3 of 7 (312 faces)"; '' for a body of one part. */
export function describePart(part: number, parts: number): string {
  if (parts < 2) return '';
  const faces = results.modes.value?.components[part]?.faces;
  return `part ${part + 1} of ${parts}${faces === undefined ? '' : ` (${count(faces)} faces)`}`;
}

export function FrequencyHint() {
  const fitted = shownFit.value;
  const worst = fitted && worstPart(fitted.errorAfter);
  if (!fitted || !worst || worst.error < LARGE) return null;
  const where = describePart(worst.part, fitted.errorAfter.length);
  const { faces, wanted } = slider.value;
  const more = Math.min(faces, Math.round(MORE_FACES * wanted));
  return (
    <div class="way-out" role="status">
      <p class="hint warning">
        The frequencies of {where || 'the result'} are off by {fixed(worst.error, 0)} %: it has too few faces
        for how it bends.
      </p>
      <div class="buttons">
        {more > wanted && (
          <button type="button" onClick={() => keepFaces(more)}>
            Keep {count(more)} faces
          </button>
        )}
        <button type="button" onClick={() => changeSettings({ maxFrequencyError: LARGE })}>
          Stop at {LARGE} %
        </button>
      </div>
    </div>
  );
}
