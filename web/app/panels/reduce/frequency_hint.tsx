/** Names the part with the largest frequency error, and offers a remedy. */

import { count, fixed } from '../../controls/numbers';
import { changeSettings, keepFaces, results, shownFit, slider } from '../../state/store';
import { say } from '../../language/say';
import { Spoken } from '../../controls/spoken';

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

/** "part 3 of 7 (312 faces)"; '' for a body with one part. */
export function describePart(part: number, parts: number): string {
  if (parts < 2) return '';
  const faces = results.modes.value?.components[part]?.faces;
  const values = { number: part + 1, all: parts };
  return faces === undefined
    ? say('part {number} of {all}', values)
    : say('part {number} of {all} ({faces} faces)', { ...values, faces: count(faces) });
}

export function FrequencyHint() {
  const fitted = shownFit.value;
  const worst = fitted && worstPart(fitted.errorAfter);
  if (!fitted || !worst || worst.error < LARGE) return null;
  const where = describePart(worst.part, fitted.errorAfter.length);
  const { faces, wanted } = slider.value;
  const told = say(
    'The frequencies of {where} are off by {error} %: it has too few faces for how it bends.',
    { where: where || say('the result'), error: fixed(worst.error, 0) },
  );
  const more = Math.min(faces, Math.round(MORE_FACES * wanted));
  return (
    <div class="way-out">
      <Spoken text={told} />
      <p class="hint warning">{told}</p>
      <div class="buttons">
        {more > wanted && (
          <button type="button" onClick={() => keepFaces(more)}>
            {say('Keep {count} faces', { count: count(more) })}
          </button>
        )}
        <button type="button" onClick={() => changeSettings({ maxFrequencyError: LARGE })}>
          {say('Stop at {error} %', { error: LARGE })}
        </button>
      </div>
    </div>
  );
}
