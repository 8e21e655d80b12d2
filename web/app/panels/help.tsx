/** The list of keys, and the meaning of terms. */

import { useHeadingFocus } from '../controls/heading_focus';
import { LanguageChoice } from '../controls/language_choice';
import { view } from '../state/store';
import { Words } from './words';
import './help.css';
import { say } from '../language/say';

const KEYS: [string, string][] = [
  ['Space', 'play or pause; in Reduce: swing or rest'],
  ['F', 'fit the view'],
  ['W', 'wireframe'],
  ['1 2 3 4', 'to the step of this number'],
  ['C', 'next colours: plain, strain, curvature; in Test: plain, deviation'],
  ['B', 'blink between original and optimized'],
  ['V', 'next view: side by side, slider, original, optimized; in Test: overlaid'],
  ['← →', 'one collapse back or forward; in Test: one step forward'],
  ['Home', 'in Test: back to the start'],
  ['D', 'in Test: the optimized mesh drives the original'],
  ['[ ]', 'smaller or larger brush'],
  ['Tab', 'focus the picture: arrows turn it, Shift and arrows move it, + and - zoom'],
  ['Enter', 'in the picture: pin or paint what is in the middle; with Shift, unpin or erase'],
  ['Ctrl+Z', 'undo; with Shift, redo'],
  ['Ctrl+O', 'open a file'],
  ['Ctrl+E', 'export'],
  [
    'Esc',
    'close this help, the pictures or Export, leave the pick tool or the brush, or cancel what is running',
  ],
  ['?', 'this help'],
];

export function Help() {
  return view.helpOpen.value ? <OpenHelp /> : null;
}

function OpenHelp() {
  const heading = useHeadingFocus();
  return (
    <aside class="panel help" aria-label={say('Help')}>
      <div class="panel-head">
        <h2 ref={heading} tabIndex={-1}>
          {say('Keys')}
        </h2>
        <button
          type="button"
          class="quiet"
          aria-label={say('Close the help')}
          onClick={() => (view.helpOpen.value = false)}
        >
          {say('Close')}
        </button>
      </div>
      <LanguageChoice />
      <dl class="keys">
        {KEYS.map(([key, meaning]) => (
          <div key={key}>
            <dt>
              <kbd>{say(key)}</kbd>
            </dt>
            <dd>{say(meaning)}</dd>
          </div>
        ))}
      </dl>
      <h2 class="words-title">{say('Words')}</h2>
      <Words />
    </aside>
  );
}
