/** The slider of the kept faces, which replays the collapses. */

import { count, fixed } from '../../controls/numbers';
import { NumberField } from '../../controls/number_field';
import type { Refused } from '../../../engine/core/core';
import { faceCount } from '../../../engine/core/mesh';
import { keyOf } from '../../../engine/stages/stage';
import { STAGES } from '../../../engine/stages/stages';
import { Toggle } from '../../controls/controls';
import {
  isLimited,
  isSharing,
  keepFaces,
  results,
  setOwnFaces,
  shownFit,
  shownMesh,
  slider,
  wantedFaces,
  wants,
} from '../../state/store';
import './scrubber.css';
import { say } from '../../language/say';

export function Scrubber() {
  const { isReady, fewest, faces: total, wanted } = slider.value;
  const value = Math.min(total, Math.max(fewest, wanted));
  const share = shownShare() ?? value / total;
  const set = (faces: number) => {
    if (Number.isFinite(faces)) keepFaces(Math.min(total, Math.max(1, Math.round(faces))));
  };
  return (
    <div class="scrubber">
      <label for="faces">{isSharing.value ? say('Kept faces of the scene') : say('Kept faces')}</label>
      <div class="track">
        <input
          id="faces"
          type="range"
          min={fewest}
          max={total}
          step={1}
          value={value}
          disabled={!isReady}
          aria-valuetext={say('{kept} of {all} faces', { kept: count(value), all: count(total) })}
          onInput={(event) => set(event.currentTarget.valueAsNumber)}
        />
        {!isSharing.value && <Marks />}
      </div>
      <ExactFaces value={value} total={total} set={set} />
      <span class="muted ratio">{total > 0 ? `${fixed(100 * share, 1)} %` : ''}</span>
      {(results.file.value?.bodies.length ?? 0) > 1 && <OwnFaces />}
    </div>
  );
}

/** The ratio of the shown mesh; null before it exists, and if the slider controls several bodies. */
function shownShare(): number | null {
  const { value: body } = results.body;
  const { value: shown } = shownMesh;
  return body && shown && !isSharing.value ? faceCount(shown.mesh) / faceCount(body.mesh) : null;
}

/** Gives the shown body its own number of faces. */
function OwnFaces() {
  return (
    <Toggle
      label="This body alone"
      checked={!isSharing.value}
      onChange={(on) => setOwnFaces(on ? wantedFaces.value : null)}
    />
  );
}

function ExactFaces({ value, total, set }: { value: number; total: number; set(faces: number): void }) {
  return (
    <div class="exact">
      <NumberField aria-label={say('Kept faces, exact')} min={1} max={total} value={value} onEnter={set} />
      <ShortReason />
    </div>
  );
}

/** Why there are not fewer faces, in a few words; the panel explains it. */
function ShortReason() {
  const { isReady, fewest, wanted, refused } = slider.value;
  const { value: fit } = shownFit;
  if (isLimited.value && !isSharing.value) {
    const faces = count(faceCount(shownMesh.value!.mesh));
    const limit = fit?.frequency?.isBinding ? say('frequency limit') : say('deviation limit');
    return <span class="stopped">{say('stopped at {faces}: {limit}', { faces, limit })}</span>;
  }
  if (!isReady || wanted > fewest) return null;
  const reason = refused && mainRefusal(refused);
  return (
    <span class="stopped">
      {reason ? say('fewest: {reason}', { reason: say(reason) }) : say('fewest possible')}
    </span>
  );
}

const REFUSALS: Record<keyof Refused, string> = {
  topology: 'parts or holes would change',
  flip: 'faces would flip',
  lock: 'seams, borders, locks',
  angle: 'angle limit',
  deviation: 'deviation limit',
};

/** What stops most of the edges that remain; null if none remains. */
function mainRefusal(refused: Refused): string | null {
  const names = Object.keys(REFUSALS) as (keyof Refused)[];
  const most = names.reduce((first, name) => (refused[name] > refused[first] ? name : first));
  return refused[most] > 0 ? REFUSALS[most] : null;
}

/** Labels closer than this share of the slider would overlap; `narrow`: in a narrow window. */
const LABEL_WIDTH = { wide: 0.045, narrow: 0.1 };
/** The first label has an additional word. */
const FIRST_LABEL = 1.6;

/** `position` on the slider, 0..1; `share`: the part of the slider that is free for the label. */
function classOf(position: number, share: number): string {
  const crowded = share > LABEL_WIDTH.narrow ? '' : ' crowded';
  if (position < LABEL_WIDTH.narrow) return `tick at-start${crowded}`;
  return `tick${position > 1 - LABEL_WIDTH.narrow ? ' at-end' : ''}${crowded}`;
}

/** Marks where the deviation crosses 0.1, 0.5 and 1 %. A click sets that number of faces. */
function Marks() {
  const history = results.history.value;
  const found = results.marks.value;
  if (!history || found?.key !== keyOf(STAGES.deviationMarks, wants.settings.value)) return null;
  const { marks } = found;
  const positionOf = (faces: number) => (faces - history.floorFaces) / (history.faces - history.floorFaces);
  return (
    <>
      {marks.map(({ deviation, faces }, i) => {
        const room = i === 0 ? Infinity : positionOf(marks[i - 1].faces) - positionOf(faces);
        const share = i === 1 ? room / FIRST_LABEL : room;
        const isLabelled = share > LABEL_WIDTH.wide;
        const meaning = say('Deviation of at most {deviation} %: {faces} faces', {
          deviation,
          faces: count(faces),
        });
        return (
          <button
            key={deviation}
            type="button"
            class={classOf(positionOf(faces), share)}
            style={{ left: `calc(8px + (100% - 16px) * ${positionOf(faces)})` }}
            title={meaning}
            aria-label={meaning}
            onClick={() => keepFaces(faces)}
          >
            {isLabelled ? (i === 0 ? say('deviation {deviation} %', { deviation }) : `${deviation} %`) : ''}
          </button>
        );
      })}
    </>
  );
}
