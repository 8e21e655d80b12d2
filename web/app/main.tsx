/** Starts the page. */

import '@fontsource-variable/inter';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app';
import { begin } from './begin';
import { listenToKeys } from './keys';
import { loadSamples } from './panels/samples';
import { isDark } from './scheme';
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
