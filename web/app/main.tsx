/** Starts the page. */

import '@fontsource-variable/inter';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app';
import { listenToKeys } from './keys';
import { loadSamples, openSample, samples } from './panels/samples';
import { isDark } from './scheme';
import { startRunner } from './state/runner';
import { startSimulations } from './state/simulation';
import './style.css';

const FIRST_SAMPLE = 'tower';

effect(() => {
  document.documentElement.dataset.theme = isDark.value ? 'dark' : 'light';
});
render(<App />, document.getElementById('app')!);
listenToKeys();
startRunner();
startSimulations();
await loadSamples();
const wanted = new URLSearchParams(location.search).get('sample') ?? FIRST_SAMPLE;
const first = samples.value.find((sample) => sample.id === wanted);
if (first) await openSample(first);
