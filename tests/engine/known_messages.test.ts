import { expect, test } from 'vitest';
import { knownMessages } from '../../web/engine/document/facts/known_messages';

const verdict = (...messages: string[]) => ({ errors: 0, warnings: messages.length, messages });

test('messages that the input had are known, per code at most as many', () => {
  const input = verdict('A at /meshes/0: old', 'A at /meshes/1: old', 'B at /: old');
  const result = verdict('A at /meshes/7: old', 'A at /: old', 'A at /nodes/1: a third', 'C at /: new');
  expect(knownMessages(result, input)).toBe(2);
  expect(knownMessages(input, input)).toBe(3);
  expect(knownMessages(result, verdict())).toBe(0);
});
