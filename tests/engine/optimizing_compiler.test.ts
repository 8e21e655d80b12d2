import { setFlagsFromString } from 'node:v8';
import { expect, it, vi } from 'vitest';
import { optimizeLater } from '../../web/cli/optimizing_compiler';

vi.mock('node:v8', () => ({ setFlagsFromString: vi.fn() }));

it('sets the budget of old versions of V8, and keeps that of newer ones', () => {
  optimizeLater('12.4.254.21-node.11');
  expect(setFlagsFromString).not.toHaveBeenCalled();
  optimizeLater('11.3.244.8-node.26');
  expect(setFlagsFromString).toHaveBeenCalledWith(expect.stringMatching(/^--wasm-tiering-budget=\d+$/));
});
