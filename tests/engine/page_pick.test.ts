/** The pick tool of the page: what a stroke does once it ends. */

import { Ray, Vector3 } from 'three';
import { expect, it, vi } from 'vitest';
import { PickTool } from '../../web/app/viewer/pick_tool';
import { grid } from './support/shapes';

let mesh = grid(4, 4);

function pickTool() {
  const tool = { radius: () => 0.1, hover: () => {}, paint: vi.fn(), finish: vi.fn() };
  let isInUse = true;
  const canvas = Object.assign(new EventTarget(), { setPointerCapture: () => {} });
  const ray = () => new Ray(new Vector3(mesh.positions[0], mesh.positions[1], 9), new Vector3(0, 0, -1));
  const host = {
    tool: () => (isInUse ? tool : null),
    mesh: () => (isInUse ? mesh : null),
    rayAt: vi.fn((_x: number, _y: number, _fromX: number) => ray()),
    isBroad: () => true,
    fail: vi.fn(),
  };
  const picking = new PickTool(canvas as unknown as HTMLCanvasElement, host);
  const send = (type: string, x: number, pointerId = 1): void => {
    const at = { clientX: x, clientY: 0, pointerId, button: 0, buttons: 1, shiftKey: false };
    canvas.dispatchEvent(Object.assign(new Event(type), at));
  };
  return { tool, send, host, picking, putDown: () => (isInUse = false) };
}

it('a stroke ends where the pointer is released', () => {
  const { tool, send } = pickTool();
  send('pointerdown', 0);
  send('pointermove', 20);
  send('pointerup', 20);
  expect([tool.paint.mock.calls.length, tool.finish.mock.calls.length]).toEqual([2, 1]);
});

it('a stroke goes on through the picture in which it has begun', () => {
  const { send, host, picking } = pickTool();
  picking.aim({ clientX: 3, clientY: 0 });
  send('pointerdown', 1);
  send('pointermove', 7);
  send('pointerup', 7);
  picking.aim({ clientX: 8, clientY: 0 });
  const calls = host.rayAt.mock.calls.map(([x, , fromX]) => [x, fromX]);
  expect([calls[0], calls.find(([x]) => x === 7), calls.at(-1)]).toEqual([
    [3, 3],
    [7, 1],
    [8, 8],
  ]);
});

it('a stroke is dropped where its tool is put down before', () => {
  const { tool, send, putDown } = pickTool();
  send('pointerdown', 0);
  putDown();
  send('pointermove', 20);
  send('pointerup', 20);
  expect([tool.paint.mock.calls.length, tool.finish.mock.calls.length]).toEqual([1, 0]);
});

it('a stroke that the system cancels is taken back, and one of another pointer goes on', () => {
  const { tool, send } = pickTool();
  send('pointerdown', 0);
  send('pointermove', 20);
  send('pointercancel', 20, 2);
  send('pointermove', 40);
  send('pointercancel', 40);
  send('pointerup', 40);
  expect([tool.paint.mock.calls.length, tool.finish.mock.calls.length]).toEqual([4, 0]);
  expect(tool.paint.mock.lastCall![0].vertices.size).toBe(0);
});

it('a search tree that fails is told once, and is built again where the tool is taken again', async () => {
  let isBroken = true;
  const workers: { onerror(event: { message?: string }): void }[] = [];
  class TreeWorker {
    onerror = (_event: { message?: string }): void => {};
    terminate = (): void => {};
    constructor() {
      workers.push(this);
    }
    postMessage(): void {
      if (isBroken) setTimeout(() => this.onerror({}));
    }
  }
  vi.stubGlobal('Worker', TreeWorker);
  mesh = grid(130, 130);
  const { host, picking } = pickTool();
  picking.prepare();
  await vi.waitUntil(() => host.fail.mock.calls.length > 0);
  picking.aim({ clientX: 0, clientY: 0 });
  expect([workers.length, host.fail.mock.calls]).toEqual([1, [[new Error('Failed to fetch its script')]]]);
  isBroken = false;
  picking.prepare();
  expect([workers.length, host.fail.mock.calls.length]).toEqual([2, 1]);
});
