// Takes a thousand seeded random actions in the built page: no error, and a heap that grows by at most 5 % after the first hundred.
// Usage: node tests/bench/page_actions.mjs [--count 1000] [--seed 1]     (after npm run build; needs Chromium)

import { spawnSync } from 'node:child_process';
import { parseArgs } from 'node:util';
import { root } from '../../scripts/setup/environment.mjs';

const { count, seed } = parseArgs({
  options: { count: { type: 'string', default: '1000' }, seed: { type: 'string', default: '1' } },
}).values;
const { status } = spawnSync(
  process.execPath,
  ['node_modules/@playwright/test/cli.js', 'test', '--reporter=list', 'tests/app/random_actions.spec.ts'],
  { cwd: root, stdio: 'inherit', env: { ...process.env, LIMBER_ACTIONS: count, LIMBER_SEED: seed } },
);
process.exit(status ?? 1);
