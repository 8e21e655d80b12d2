/** Notes on the chosen modes, below the gallery. */

import { describeHotSpots, differentPairs } from '../../../engine/report/hot_spots';
import { localModes, spellModes, suggestedModes } from '../../../engine/core/mode_set';
import { resolveModes } from '../../../engine/settings/options';
import { changeSettings, shownOverview, wants } from '../../state/store';
import type { ModesResult } from '../../worker/protocol';
import { guidingModes } from './mode_choice';
import './mode_notes.css';
import { say, sentence } from '../../language/say';

export function ModeNotes({ modes }: { modes: ModesResult }) {
  const chosen = guidingModes();
  const local = localModes(modes, chosen);
  const shared = shownOverview.value?.shared;
  const hotSpots = shared && describeHotSpots(differentPairs(shared, modes.modesPerComponent, chosen));
  return (
    <div class="mode-notes" role="status">
      {local.length > 0 && <LocalNote modes={modes} local={local} />}
      {hotSpots && <p>{sentence(hotSpots)}</p>}
      {shared && local.length === 0 && !hotSpots && (
        <p class="muted">
          {say('Click the mode that looks like the motion you expect; tick more to blend several.')}
        </p>
      )}
    </div>
  );
}

function LocalNote({ modes, local }: { modes: ModesResult; local: number[] }) {
  const settings = wants.settings.value;
  // As many modes as are chosen by default.
  const better = suggestedModes(modes, resolveModes({ ...settings, modes: 'auto' }).length);
  return (
    <p>
      {describeLocal(local)}
      {better.length > 0 && (
        <button type="button" onClick={() => changeSettings({ modes: better, modeWeights: [] })}>
          {say('Leave local modes out')}
        </button>
      )}
    </p>
  );
}

function describeLocal(local: number[]): string {
  return local.length === 1
    ? say('Mode {mode} is local: little of the body moves.', { mode: local[0] })
    : say('Modes {modes} are local: little of the body moves.', { modes: sentence(spellModes(local)) });
}
