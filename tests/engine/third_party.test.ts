// THIRD_PARTY.md names everything that ships.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { thirdParty } from '../../scripts/docs/third-party.mjs';

test('the list of third-party software agrees with the lock file', async () => {
  // node scripts/docs/third-party.mjs writes it.
  const written = readFileSync(join(import.meta.dirname, '..', '..', 'THIRD_PARTY.md'), 'utf8');
  expect(written).toBe(await thirdParty());
});
