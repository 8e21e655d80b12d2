/** The page before a file is open: its purpose, an area to drop a file, and the samples. */

import { LanguageChoice } from '../../controls/language_choice';
import { useEffect, useRef } from 'preact/hooks';
import { pickFiles } from '../../files/files';
import { openSample, samples } from '../../files/samples';
import type { Sample } from '../../files/samples';
import { status } from '../../state/store';
import { SampleCards } from '../../viewer/picture/sample_cards';
import { isMotionReduced } from '../../state/scheme';
import './start_screen.css';
import { say, sayCounted } from '../../language/say';

export function StartScreen() {
  const noteFocus = useHandover();
  if (status.busy.value) return null;
  return (
    <div class="start" onFocusCapture={noteFocus}>
      <div class="start-drop">
        <LanguageChoice />
        <h2>{say('Fewer triangles that still move right')}</h2>
        <p>
          {say(
            'Drop a mesh here: Limber finds how it bends and swings, and removes faces where that does not show.',
          )}
        </p>
        <button type="button" class="primary" onClick={() => void pickFiles()}>
          {say('Open a file')}
        </button>
        <p class="muted">
          {say('GLB, glTF with its files, OBJ, STL, PLY or OFF, or a ZIP of these.')}{' '}
          <strong>{say('Your file stays on this computer.')}</strong>
        </p>
      </div>
      {samples.value.length > 0 && <Cards />}
    </div>
  );
}

/** Focuses the current step if the focused element disappears with this screen; returns the handler that records that an element has the focus. */
function useHandover(): () => void {
  const hadFocus = useRef(false);
  useEffect(() => () => void (hadFocus.current && requestAnimationFrame(focusStep)), []);
  return () => (hadFocus.current = true);
}

function focusStep(): void {
  // If the focus has moved elsewhere meanwhile, it stays there.
  if (document.activeElement !== document.body) return;
  document.querySelector<HTMLElement>('.steps [aria-current]')?.focus({ preventScroll: true });
}

function Cards() {
  const list = useRef<HTMLUListElement>(null);
  useEffect(() => {
    const canvases = [...list.current!.querySelectorAll('canvas')];
    const addresses = samples.value.map(({ file }) => `./samples/${file}`);
    const cards = SampleCards.open(addresses, canvases, isMotionReduced());
    return () => cards?.dispose();
  }, [samples.value]);
  return (
    <section class="start-samples" aria-label={say('Or try a sample')}>
      <h3>{say('Or try a sample')}</h3>
      <ul class="cards" ref={list}>
        {samples.value.map((sample) => (
          <li key={sample.id}>
            <Card sample={sample} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Card({ sample }: { sample: Sample }) {
  return (
    <button type="button" class="card" onClick={() => void openSample(sample)}>
      <canvas width={440} height={300} aria-hidden="true" />
      <strong>{say(sample.name)}</strong>
      <span class="muted">{sayCounted(sample.faces, '{count} face', '{count} faces')}</span>
      <span>{say(sample.about)}</span>
    </button>
  );
}
