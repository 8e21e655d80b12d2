/** The reason why a reduction has stopped before the requested number of faces. */

import { count, fixed } from '../../controls/numbers';
import { describeRefused } from '../../../engine/report/stop_report';
import type { Settings } from '../../../engine/settings/options';
import type { FrequencyFinding, Tried } from '../../../engine/body/body_result';
import { changeSettings, isLimited, results, shownFit, shownMesh, wantedFaces } from '../../state/store';
import type { HistorySummary } from '../../worker/protocol';
import { say, sayCounted, sentence } from '../../language/say';

export const ACROSS_SEAMS = 'Collapse across texture seams';

/** Explains why more faces remain than requested: the first limit that was reached, and the request that could not be met. */
export function StopReason() {
  const history = results.history.value;
  if (!history) return null;
  const frequency = shownFit.value?.frequency;
  const guard = shownFit.value?.guard;
  const shown = (shownMesh.value?.mesh.triangles.length ?? 0) / 3;
  return (
    <>
      {history.note !== '' && <p class="hint warning">{sentence(`${history.note}.`)}</p>}
      {wantedFaces.value < history.floorFaces && !isLimited.value && <FloorReason history={history} />}
      {guard && (
        <p class="hint warning">
          {sayCounted(
            shown,
            'Stopped at {count} face: the next collapses would take the surface more than {limit}\u00a0% of the diagonal away.',
            'Stopped at {count} faces: the next collapses would take the surface more than {limit}\u00a0% of the diagonal away.',
            { limit: fixed(guard.limit, 2) },
          )}
        </p>
      )}
      {guard && <Cure text="Lift the limit" change={{ maxDeviation: 0 }} />}
      {frequency && (
        <p class={frequency.isBinding ? 'hint warning' : 'hint'}>{describeFrequency(frequency, shown)}</p>
      )}
    </>
  );
}

/** The reason why the history itself ends. */
function FloorReason({ history }: { history: HistorySummary }) {
  const reason = describeRefused(history.refused)
    .split(/, (?=\d)/)
    .map(sentence)
    .join(', ');
  return (
    <>
      <p class="hint warning">
        {sayCounted(
          history.floorFaces,
          'Stopped at {count} face: {reason}.',
          'Stopped at {count} faces: {reason}.',
          { reason },
        )}
        {history.blockedBySeams &&
          say(' Turn on “{control}” under More to go on.', { control: say(ACROSS_SEAMS) })}
      </p>
      {history.blockedBySeams && <Cure text="Turn it on" change={{ seams: 'cross' }} />}
    </>
  );
}

/** A button for the remedy that a sentence names. */
function Cure({ text, change }: { text: string; change: Partial<Settings> }) {
  return (
    <div class="buttons">
      <button type="button" onClick={() => changeSettings(change)}>
        {say(text)}
      </button>
    </div>
  );
}

function describeFrequency({ isBinding, error, limit, tried }: FrequencyFinding, faces: number): string {
  const off = say('the first six frequencies are off by at most {error} %', { error: fixed(error, 2) });
  if (!isBinding) return say('With {faces} faces {off}.', { faces: count(faces), off });
  const failures = tried.filter((one) => one.error > limit && one.faces < faces);
  const nearest = failures.reduce<Tried | null>(
    (most, one) => (most && most.faces > one.faces ? most : one),
    null,
  );
  const fewer = nearest
    ? say(' With {faces} faces it would be {error} %.', {
        faces: count(nearest.faces),
        error: fixed(nearest.error, 2),
      })
    : '';
  return say('Stopped at {faces} faces, where {off}.', { faces: count(faces), off }) + fewer;
}
