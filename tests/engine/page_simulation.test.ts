/** When the Test step starts its simulation. */

import { beforeEach, expect, it, vi } from 'vitest';
import { simulationKey } from '../../web/app/state/simulation';
import { changeSettings, results, status, view, wantedKey, wants } from '../../web/app/state/store';
import { STAGES } from '../../web/engine/stages/stages';

vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('document', { hidden: false, baseURI: 'http://localhost/' });
});

const mesh = { positions: new Float32Array(9), triangles: Uint32Array.of(0, 1, 2) };
const nodeMatrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

beforeEach(() => {
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
