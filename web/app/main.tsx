/** Starts the page. Shared styles come first, because the styles of components build on them. */

import './styles/tokens.css';
import './styles/base.css';
import './styles/layout.css';
import './controls/controls.css';
import '@fontsource-variable/inter';
import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app';
import { loadSamples } from './files/samples';
import { startLanguage } from './language/language';
import { listenToKeys } from './shortcuts';
import { openAtStart } from './startup';
import { followModes } from './state/follow_modes';
import { keepOffline } from './state/offline';
import { startRunner } from './state/runner';
import { client } from './state/running';
import { isDark } from './state/scheme';
import { startSimulations } from './state/simulation';
import { followSteps } from './state/steps/steps';
import { results } from './state/store';

effect(() => {
  document.documentElement.dataset.theme = isDark.value ? 'dark' : 'light';
});
// The first paint is already in the right language.
await startLanguage();
followSteps();
render(<App />, document.getElementById('app')!);
listenToKeys();
startRunner();
followModes();
startSimulations();
await loadSamples();
// Caching the page would compete with its start for the network.
void client
  .ready()
  .catch(() => null)
  .then(keepOffline);
await openAtStart();
if (!results.file.value) void client.warmUp().catch(() => null);
