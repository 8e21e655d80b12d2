/** Why a reduction has stopped before the wanted number of faces. */

import { count, fixed } from '../../controls/numbers';
import { describeRefused } from '../../../engine/report/stop_report';
import type { Settings } from '../../../engine/settings/options';
import type { FrequencyFinding, Tried } from '../../../engine/body/body_result';
import { changeSettings, results, shownFit, shownMesh, wantedFaces } from '../../state/store';

export const ACROSS_SEAMS = 'Collapse across texture seams';

/** Says why more faces are left than asked for, and which request could not be met. */
export function StopReason() {
  const history = results.history.value;
  if (!history) return null;
  const frequency = shownFit.value?.frequency;
  const guard = shownFit.value?.guard;
  const shown = (shownMesh.value?.mesh.triangles.length ?? 0) / 3;
  return (
    <>
      {history.note !== '' && <p class="hint warning">{history.note}.</p>}
      {wantedFaces.value < history.floorFaces && (
        <p class="hint warning">
          Stopped at {count(history.floorFaces)} faces: {describeRefused(history.refused)}.
          {history.blockedBySeams && ` Turn on “${ACROSS_SEAMS}” under More to go on.`}
        </p>
      )}
      {wantedFaces.value < history.floorFaces && history.blockedBySeams && (
        <Cure text="Turn it on" change={{ seams: 'cross' }} />
      )}
      {guard && (
        <p class="hint warning">
          Stopped at {count(shown)} faces: with fewer the surface would go too far, more than{' '}
          {fixed(guard.limit, 2)} % of the diagonal.
        </p>
      )}
      {guard && <Cure text="Let it go farther" change={{ maxDeviation: 0 }} />}
      {frequency && (
        <p class={frequency.isBinding ? 'hint warning' : 'hint'}>{describeFrequency(frequency, shown)}</p>
      )}
    </>
  );
}

/** Does what a sentence names. */
function Cure({ text, change }: { text: string; change: Partial<Settings> }) {
  return (
    <div class="buttons">
      <button type="button" onClick={() => changeSettings(change)}>
        {text}
      </button>
    </div>
  );
}

function describeFrequency({ isBinding, error, limit, tried }: FrequencyFinding, faces: number): string {
  const off = `the first six frequencies are off by at most ${fixed(error, 2)} %`;
  if (!isBinding) return `With ${count(faces)} faces ${off}.`;
  const failures = tried.filter((one) => one.error > limit && one.faces < faces);
  const nearest = failures.reduce<Tried | null>(
    (most, one) => (most && most.faces > one.faces ? most : one),
    null,
  );
  const fewer = nearest
    ? ` With ${count(nearest.faces)} faces it would be ${fixed(nearest.error, 2)} %.`
    : '';
  return `Stopped at ${count(faces)} faces, where ${off}.${fewer}`;
}
