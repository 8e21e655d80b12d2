/** How a page learns of a new version, and how it gets there, also where another tab brings it. */

import { beforeAll, beforeEach, expect, it, vi } from 'vitest';
import { keepOffline } from '../../web/app/state/offline';
import { status } from '../../web/app/state/store';

// The state of the page asks for the colour scheme.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const reload = vi.fn();
const waiting = { state: 'installed', postMessage: vi.fn() };
const serviceWorker = Object.assign(new EventTarget(), {
  controller: {},
  ready: Promise.resolve(),
  register: () => Promise.resolve(Object.assign(new EventTarget(), { waiting })),
});

vi.stubEnv('PROD', true);
vi.stubGlobal('navigator', { serviceWorker });
vi.stubGlobal('location', { reload });
vi.stubGlobal('crossOriginIsolated', true);

const press = (): void => status.notice.value!.action!.run();
const takeOver = (): void => void serviceWorker.dispatchEvent(new Event('controllerchange'));

beforeAll(keepOffline);
beforeEach(() => reload.mockClear());

it('a new version takes over where it is asked for, and then the page is loaded again', () => {
  press();
  expect([waiting.postMessage.mock.calls, reload.mock.calls.length]).toEqual([[['take over']], 0]);
  takeOver();
  expect(reload).toHaveBeenCalledOnce();
});

it('the offer of a version that another tab has brought loads the page again', () => {
  const { value: offered } = status.notice;
  waiting.state = 'activated';
  offered!.action!.run();
  expect(reload).toHaveBeenCalledOnce();
});

it('a page whose version another tab has replaced is told so', () => {
  status.notice.value = null;
  takeOver();
  expect(status.notice.value).toMatchObject({ action: { label: 'Reload' } });
  press();
  expect(reload).toHaveBeenCalledOnce();
});
