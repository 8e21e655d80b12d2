/** When the Test step starts its simulation, and what it says of workers that cannot. */

import { expose } from 'comlink';
import { beforeEach, expect, it, vi } from 'vitest';
import { currentNoise, noiseEnd } from '../../web/app/panels/simulate/simulate_axes';
import { checkConvergence, convergenceCheck } from '../../web/app/state/convergence';
import { reset, simulationKey, startSimulations } from '../../web/app/state/simulation';
import { changeSettings, results, status, view, wantedKey, wants } from '../../web/app/state/store';
import { twin } from '../../web/app/state/twin';
import { STAGES } from '../../web/engine/stages/stages';

vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('document', { hidden: false, baseURI: 'http://localhost/', addEventListener: () => {} });
  vi.stubGlobal('navigator', {});
});

let workers: FakeWorker[] = [];
let whyNotLoaded = 'No network.';

/** A worker whose program or core cannot be loaded. */
class FakeWorker {
  private readonly ports = new MessageChannel();
  private readonly events = new EventTarget();
  postMessage = this.ports.port1.postMessage.bind(this.ports.port1);
  removeEventListener = this.ports.port1.removeEventListener.bind(this.ports.port1);

  constructor() {
    workers.push(this);
    this.ports.port1.start();
    const load = () => {
      throw new Error(whyNotLoaded);
    };
    expose({ load, measure: () => new Promise(() => {}) }, this.ports.port2);
  }

  addEventListener(name: 'message', listener: () => void): void {
    (name === 'message' ? this.ports.port1 : this.events).addEventListener(name, listener);
  }

  fail(): void {
    this.events.dispatchEvent(new Event('error'));
  }

  terminate(): void {
    this.ports.port1.close();
  }
}
vi.stubGlobal('Worker', FakeWorker);

const mesh = { positions: new Float32Array(9), triangles: Uint32Array.of(0, 1, 2) };
const nodeMatrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

beforeEach(() => {
  workers = [];
  view.step.value = 'test';
  changeSettings({ fit: 'off', pins: '' });
  wants.faces.value = 1;
  results.file.value = { bodies: [{ nodeMatrix }] } as never;
  results.body.value = { mesh } as never;
  results.mesh.value = { mesh } as never;
  // A fit that changes nothing has no mesh of its own.
  results.fitted.value = { result: null, key: wantedKey(STAGES.fitted) } as never;
});

it('a result that is not fitted moves on while other work is done', () => {
  const { value: key } = simulationKey;
  expect(key).not.toBeNull();
  status.isComputing.value = true;
  expect(simulationKey.value).toBe(key);
  status.isComputing.value = false;
});

it('pins that are found later start it once more', () => {
  changeSettings({ pins: 'vertices:1' });
  results.fitted.value = { result: null, key: wantedKey(STAGES.fitted) } as never;
  const { value: before } = simulationKey;
  results.pins.value = { text: 'vertices:1', vertices: Uint32Array.of(1) };
  expect([before === null, simulationKey.value === before]).toEqual([false, false]);
});

it('a core that could not be loaded is loaded again by Reset', async () => {
  reset();
  await vi.waitUntil(() => twin.failure.value === 'No network.');
  reset();
  expect([twin.failure.value, workers.length]).toEqual([null, 2]);
});

it('a core that is gone from the host asks for a reload', async () => {
  whyNotLoaded = 'Failed to fetch dynamically imported module: http://localhost/wasm/0123456789ab/a.mjs';
  reset();
  await vi.waitUntil(() => twin.failure.value !== null);
  expect(twin.failure.value).toContain('reload the page, and your work is restored');
});

it('a check whose program cannot be loaded says so', async () => {
  void checkConvergence();
  workers[0].fail();
  await vi.waitUntil(() => convergenceCheck.value !== null);
  expect(convergenceCheck.value!.failure).toBe(
    'The simulation has stopped: its program could not be loaded.',
  );
});

it('a noise floor that is measured no more is not told as the present one, but until when it was', () => {
  const sample = (time: number, noise: number | null) => ({ time, noise, mean: 1, max: 1 }) as never;
  expect([currentNoise([]), noiseEnd([])]).toEqual([null, null]);
  const measured = [sample(0, 0.2), sample(1, 0.3)];
  expect([currentNoise(measured), noiseEnd(measured)]).toEqual([0.3, null]);
  const given = [...measured, sample(2, null)];
  expect([currentNoise(given), noiseEnd(given)]).toEqual([null, 1]);
  // The chart has left it behind.
  expect(noiseEnd([...given, sample(12, null)])).toBeNull();
});

it('the last frame keeps the scale of its colours while another result is made', () => {
  startSimulations();
  twin.frame.value = twin.numbers.value = { bodies: { original: { stepSeconds: 0 } } } as never;
  twin.worst.value = 4;
  status.isComputing.value = true;
  results.fitted.value = null;
  expect([simulationKey.value, twin.numbers.value, twin.worst.value]).toEqual([null, null, 4]);
  expect(twin.frame.value).not.toBeNull();
  status.isComputing.value = false;
});
