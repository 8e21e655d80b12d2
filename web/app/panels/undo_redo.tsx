/** The buttons for Undo and Redo. */

import { canRedo, canUndo, redo, undo } from '../state/undo';
import { say } from '../language/say';

export function UndoRedo() {
  return (
    <div class="undo">
      <button
        type="button"
        class="quiet"
        disabled={!canUndo()}
        title={say('Undo (Ctrl+Z)')}
        aria-label={say('Undo')}
        onClick={undo}
      >
        <Arrow />
      </button>
      <button
        type="button"
        class="quiet"
        disabled={!canRedo()}
        title={say('Redo (Ctrl+Shift+Z)')}
        aria-label={say('Redo')}
        onClick={redo}
      >
        <Arrow isMirrored />
      </button>
    </div>
  );
}

/** Points back; mirrored it points forward. */
function Arrow({ isMirrored = false }: { isMirrored?: boolean }) {
  return (
    <svg
      width="16"
      height="16"
      viewBox="0 0 16 16"
      aria-hidden="true"
      transform={isMirrored ? 'scale(-1 1)' : undefined}
    >
      <path
        d="M6 2 2.5 5.5 6 9M3 5.5h6.5a4 4 0 0 1 0 8H6"
        fill="none"
        stroke="currentColor"
        stroke-width="1.6"
      />
    </svg>
  );
}
