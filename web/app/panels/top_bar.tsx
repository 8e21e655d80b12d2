/** The bar at the top: brand, files, steps, and the tools of the whole page. */

import { LanguageChoice } from '../controls/language_choice';
import { pickFiles } from '../files/files';
import { isReloadFaster, reloadPage } from '../state/offline';
import { goToStep } from '../state/steps/steps';
import { results, status, view, wants } from '../state/store';
import type { Step, Theme } from '../state/store';
import { Samples } from './model/samples';
import { ShareLink } from './share_link';
import { UndoRedo } from './undo_redo';
import './top_bar.css';
import { say } from '../language/say';

const STEPS: { id: Step; text: string }[] = [
  { id: 'model', text: 'Model' },
  { id: 'motion', text: 'Motion' },
  { id: 'reduce', text: 'Reduce' },
  { id: 'test', text: 'Test' },
];

const NEXT_THEME: Record<Theme, Theme> = { system: 'light', light: 'dark', dark: 'system' };
const THEME_NAMES: Record<Theme, string> = { system: 'Auto', light: 'Light', dark: 'Dark' };

export function TopBar() {
  return (
    <header class="top">
      <h1 class="brand" aria-label={say('Limber')}>
        <img src="./icon.svg" alt="" width="24" height="24" />
        <span class="brand-name">{say('Limber')}</span>
      </h1>
      <div class="files">
        <button type="button" onClick={() => void pickFiles()} title={say('Open a file (Ctrl+O)')}>
          {say('Open')}
        </button>
        <Samples />
      </div>
      <Steps />
      <div class="tools">
        <UndoRedo />
        <ShareLink />
        <ThreadNote />
        <ThemeButton />
        <LanguageChoice />
        <HelpButton />
        <ExportButton />
      </div>
    </header>
  );
}

function Steps() {
  return (
    <nav class="steps" aria-label={say('Steps')}>
      {STEPS.map(({ id, text }, i) => (
        <button
          key={id}
          type="button"
          aria-current={view.step.value === id ? 'step' : undefined}
          onClick={() => goToStep(id)}
        >
          <span class="ordinal">{i + 1}</span>
          {say(text)}
        </button>
      ))}
    </nav>
  );
}

function ThreadNote() {
  if (status.threads.value !== 1) return null;
  return (
    <>
      <span
        class="chip"
        title={say(
          'This page has no shared memory (COOP and COEP headers), so the core runs on one thread. Everything works.',
        )}
      >
        {say('1 thread')}
      </span>
      {isReloadFaster.value && (
        <button
          type="button"
          class="quiet"
          title={say('After a reload, this page can use several threads; your work is restored.')}
          onClick={reloadPage}
        >
          {say('Reload for more')}
        </button>
      )}
    </>
  );
}

function ThemeButton() {
  const theme = view.theme.value;
  return (
    <button
      type="button"
      class="quiet"
      aria-label={say('Colour scheme: {scheme}', { scheme: say(THEME_NAMES[theme]) })}
      title={say('Colour scheme: system, light, dark')}
      onClick={() => (view.theme.value = NEXT_THEME[theme])}
    >
      {say(THEME_NAMES[theme])}
    </button>
  );
}

function HelpButton() {
  return (
    <button
      type="button"
      class="quiet"
      aria-label={say('Help')}
      aria-expanded={view.helpOpen.value}
      onClick={() => (view.helpOpen.value = !view.helpOpen.value)}
    >
      ?
    </button>
  );
}

function ExportButton() {
  return (
    <button
      type="button"
      class="primary"
      disabled={!results.mesh.value}
      aria-expanded={wants.exportOpen.value}
      title={say('Export (Ctrl+E)')}
      onClick={() => (wants.exportOpen.value = !wants.exportOpen.value)}
    >
      {say('Export')}
    </button>
  );
}
