/** The bar at the top: brand, files, steps, undo, link, theme, export. */

import { useState } from 'preact/hooks';
import { results, status, view, wants } from '../state/store';
import type { Step, Theme } from '../state/store';
import { pickFiles } from '../files/files';
import { canRedo, canUndo, redo, undo } from '../state/undo';
import { count } from '../controls/numbers';
import { Samples, samples } from './model/samples';
import { writeLink } from '../state/link';

const STEPS: { id: Step; text: string }[] = [
  { id: 'model', text: 'Model' },
  { id: 'motion', text: 'Motion' },
  { id: 'reduce', text: 'Reduce' },
  { id: 'test', text: 'Test' },
];

const NEXT_THEME: Record<Theme, Theme> = { system: 'light', light: 'dark', dark: 'system' };

export function TopBar() {
  return (
    <header class="top">
      <h1 class="brand">
        <img src="./icon.svg" alt="" width="24" height="24" />
        Limber
      </h1>
      <div class="files">
        <button type="button" onClick={() => void pickFiles()} title="Open a file (Ctrl+O)">
          Open
        </button>
        <Samples />
      </div>
      <Steps />
      <div class="tools">
        <UndoRedo />
        <ShareLink />
        {status.threads.value === 1 && (
          <span
            class="chip"
            title="This page has no shared memory (COOP and COEP headers), so the core runs on one thread. Everything works."
          >
            1 thread
          </span>
        )}
        <button
          type="button"
          class="quiet"
          aria-label={`Colour scheme: ${view.theme.value}`}
          title="Colour scheme: system, light, dark"
          onClick={() => (view.theme.value = NEXT_THEME[view.theme.value])}
        >
          {{ system: 'Auto', light: 'Light', dark: 'Dark' }[view.theme.value]}
        </button>
        <button
          type="button"
          class="quiet"
          aria-label="Help"
          aria-expanded={view.helpOpen.value}
          onClick={() => (view.helpOpen.value = !view.helpOpen.value)}
        >
          ?
        </button>
        <button
          type="button"
          class="primary"
          disabled={!results.mesh.value}
          aria-expanded={wants.exportOpen.value}
          title="Export (Ctrl+E)"
          onClick={() => (wants.exportOpen.value = !wants.exportOpen.value)}
        >
          Export
        </button>
      </div>
    </header>
  );
}

function UndoRedo() {
  return (
    <div class="undo">
      <button
        type="button"
        class="quiet"
        disabled={!canUndo()}
        title="Undo (Ctrl+Z)"
        aria-label="Undo"
        onClick={undo}
      >
        <Arrow />
      </button>
      <button
        type="button"
        class="quiet"
        disabled={!canRedo()}
        title="Redo (Ctrl+Shift+Z)"
        aria-label="Redo"
        onClick={redo}
      >
        <Arrow isMirrored />
      </button>
    </div>
  );
}

const COPIED_MILLISECONDS = 2000;
/** Links longer than this are cut by some programs. */
const LONG_LINK = 8000;

function ShareLink() {
  const [isCopied, setCopied] = useState(false);
  const copy = async () => {
    const link = shareLink();
    await navigator.clipboard.writeText(link);
    setCopied(true);
    setTimeout(() => setCopied(false), COPIED_MILLISECONDS);
    if (link.length > LONG_LINK)
      status.notice.value = {
        kind: 'info',
        text: `The link has ${count(link.length)} letters, as it holds what was painted or pinned: some programs cut it.`,
      };
  };
  return (
    <button
      type="button"
      class="quiet"
      disabled={!results.file.value}
      title="Copy a link with all settings; the file itself stays here"
      onClick={() => void copy()}
    >
      {isCopied ? 'Copied' : 'Share link'}
    </button>
  );
}

/** All settings and, where it is a sample, the file. */
function shareLink(): string {
  const file = results.file.value!.name;
  const sample = samples.value.find((one) => one.file === file);
  const { settings, faces, body } = wants;
  const wanted = { settings: settings.value, faces: faces.value, body: body.value, file };
  const query = sample ? `?sample=${sample.id}` : '';
  return `${location.origin}${location.pathname}${query}#${writeLink(wanted)}`;
}

/** Back; mirrored: on again. */
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

function Steps() {
  return (
    <nav class="steps" aria-label="Steps">
      {STEPS.map(({ id, text }, i) => (
        <button
          key={id}
          type="button"
          aria-current={view.step.value === id ? 'step' : undefined}
          onClick={() => {
            view.step.value = id;
            view.picking.value = false;
          }}
        >
          <span class="ordinal">{i + 1}</span>
          {text}
        </button>
      ))}
    </nav>
  );
}
