/** The service worker's side of the page: works offline, shared memory on hosts that send no headers, new versions. */

import { signal } from '@preact/signals';
import { awaited } from './link';
import { results, status } from './store';
import { say } from '../language/say';

const RELOADED_KEY = 'limber-reloaded';

/** Whether everything is cached, so that the page works offline. */
export const isOfflineReady = signal(false);
/** Whether a reload would give the page the shared memory that it lacks now. */
export const isReloadFaster = signal(false);

/** Reloads the page; the session is saved and restored. */
export const reloadPage = (): void => location.reload();

/** Starts to cache the page. Does nothing in development and in browsers without service workers. */
export async function keepOffline(): Promise<void> {
  if (!import.meta.env.PROD || !navigator.serviceWorker) return;
  try {
    const registration = await navigator.serviceWorker.register('./service_worker.js');
    followUpdates(registration);
    followTakeOvers();
    await navigator.serviceWorker.ready;
    isOfflineReady.value = true;
    if (!crossOriginIsolated) seekIsolation();
  } catch {
    // The page works without it: a host or a private window may refuse service workers.
  }
}

/** The service worker adds the missing headers at the next load: the page reloads at once if nothing is open, and only once. */
function seekIsolation(): void {
  if (sessionStorage.getItem(RELOADED_KEY)) return;
  sessionStorage.setItem(RELOADED_KEY, '1');
  const isIdle = !results.file.value && !status.busy.value && !awaited.value && location.search === '';
  if (isIdle) reloadPage();
  else isReloadFaster.value = true;
}

/** Announces a new version; `run` loads it. */
function tellVersion(run: () => void): void {
  status.notice.value = {
    kind: 'info',
    text: say('A new version is ready. Your work is restored after a reload.'),
    action: { label: 'Reload', run },
  };
}

function followUpdates(registration: ServiceWorkerRegistration): void {
  const offer = (waiting: ServiceWorker): void => {
    if (navigator.serviceWorker.controller) tellVersion(() => takeOver(waiting));
  };
  if (registration.waiting) offer(registration.waiting);
  registration.addEventListener('updatefound', () => {
    const { installing } = registration;
    installing?.addEventListener('statechange', () => {
      if (installing.state === 'installed') offer(installing);
    });
  });
}

/** Another tab may activate the new version: the files that this page still loads then belong to another version than the page. */
function followTakeOvers(): void {
  const { serviceWorker } = navigator;
  let isControlled = serviceWorker.controller !== null;
  serviceWorker.addEventListener('controllerchange', () => {
    if (isControlled) tellVersion(reloadPage);
    isControlled = true;
  });
}

function takeOver(waiting: ServiceWorker): void {
  // If another tab has activated it, there is nothing left to wait for.
  if (waiting.state !== 'installed') return reloadPage();
  navigator.serviceWorker.addEventListener('controllerchange', reloadPage, { once: true });
  waiting.postMessage('take over');
}

const MISSING =
  /dynamically imported module|importing a module script|Failed to fetch|NetworkError|Load failed/i;

/** Whether an error means that a file of the page could not be loaded: the network is down, or the host has a new version. */
export const isMissingFile = (error: unknown): boolean =>
  error instanceof Error && MISSING.test(error.message);
