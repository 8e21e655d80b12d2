/** A handle to drag the result out of the page: dropped on a folder or another program, it becomes a file there. */

import { exportFormatOf } from '../../worker/export_form';
import { exportRequest } from '../../state/export_request';
import { wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { say } from '../../language/say';

/** ms for which a dropped file can still be fetched. */
const KEPT_MILLISECONDS = 60_000;

/** Only Chromium lets a page be the source of dragged files; this property identifies it. */
const canDragOut = 'userAgentData' in navigator;

export function DragOut({ exported }: { exported: ExportResult | null }) {
  if (!canDragOut) return null;
  return (
    <div
      class="drag-out"
      draggable={exported !== null}
      aria-hidden="true"
      title={say('Drag it onto a folder, or into a program that takes files')}
      onDragStart={(event) => exported && handOut(event, exported)}
    >
      <svg viewBox="0 0 16 20" width="16" height="20">
        <path d="M1 1h9l5 5v13H1z M10 1v5h5" fill="none" stroke="currentColor" stroke-width="1.4" />
      </svg>
      <span class="filename">{exportRequest().output}</span>
      <span class="muted">{say('drag it out')}</span>
    </div>
  );
}

function handOut(event: DragEvent, { bytes }: ExportResult): void {
  const { type } = exportFormatOf(wants.settings.value);
  const address = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  event.dataTransfer!.effectAllowed = 'copy';
  event.dataTransfer!.setData('DownloadURL', `${type}:${exportRequest().output}:${address}`);
  setTimeout(() => URL.revokeObjectURL(address), KEPT_MILLISECONDS);
}
