/** When the Test step starts its simulation, and what it says of workers that cannot. */

import { expose } from 'comlink';
import { beforeEach, expect, it, vi } from 'vitest';
import { reset, simulationKey } from '../../web/app/state/simulation';
import { changeSettings, results, status, view, wantedKey, wants } from '../../web/app/state/store';
import { twin } from '../../web/app/state/twin';
import { STAGES } from '../../web/engine/stages/stages';

vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('document', { hidden: false, baseURI: 'http://localhost/' });
  vi.stubGlobal('navigator', {});
});

let workers: FakeWorker[] = [];

/** A worker whose core cannot be loaded. */
class FakeWorker {
  private readonly ports = new MessageChannel();
  postMessage = this.ports.port1.postMessage.bind(this.ports.port1);
  addEventListener = this.ports.port1.addEventListener.bind(this.ports.port1);
  removeEventListener = this.ports.port1.removeEventListener.bind(this.ports.port1);

  constructor() {
    workers.push(this);
    this.ports.port1.start();
    const load = () => {
      throw new Error('No network.');
    };
    expose({ load }, this.ports.port2);
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
