/** Starts the page. */

import '@fontsource-variable/inter';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app';
import { begin } from './startup';
import { listenToKeys } from './shortcuts';
import { loadSamples } from './panels/model/samples';
import { isDark } from './state/scheme';
import { startRunner } from './state/runner';
import { startSimulations } from './state/simulation';
import './style.css';
import './reduce.css';

effect(() => {
  document.documentElement.dataset.theme = isDark.value ? 'dark' : 'light';
});
render(<App />, document.getElementById('app')!);
listenToKeys();
startRunner();
startSimulations();
await loadSamples();
await begin();
