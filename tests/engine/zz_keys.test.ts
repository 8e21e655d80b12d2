import { test } from 'vitest';
import { writeFileSync } from 'node:fs';
import { collectMessages } from './support/messages';
import { OPTIONS } from '../../web/engine/settings/options';
import { METHODS } from '../../web/engine/core/methods';
import { SCENARIOS } from '../../web/engine/core/scenarios';
import { SOLVER_NAMES, profileOf } from '../../web/engine/solvers/profiles';
test('k', () => {
  const { keys, bare } = collectMessages();
  const o = Object.values(OPTIONS).map((x: any) => [x.page, x.label, x.help, x.unit].join(' | '));
  const s = SOLVER_NAMES.flatMap((n) => { const p = profileOf(n); return [p.label, p.words, ...p.parameters.flatMap((q) => [q.words, q.unit])]; });
  writeFileSync('/tmp/keys.txt', [...keys.keys()].join('\n') + '\n--bare\n' + bare.join('\n') + '\n--solvers\n' + [...new Set(s)].join('\n'));
});
