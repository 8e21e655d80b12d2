/**
 * Bad inputs of every kind, each with the sentence that it gets: tests/engine/bad_inputs/sentences.txt has them all, to be
 * read. `npx vitest run FILE -u` writes it anew.
 */

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import { describeFailure, EXIT } from '../../web/cli/failure';
import { openModel } from '../../web/engine/document/open';
import { readBinding } from '../../web/engine/report/binding_file';
import { readSettingsFile } from '../../web/engine/report/settings_reader';
import { readBatchConfig } from '../../web/engine/settings/batch_config';
import { parseColliders } from '../../web/engine/settings/collider_text';
import { engineValues } from '../../web/engine/settings/engine_text';
import { parsePins } from '../../web/engine/settings/pin_text';
import type { SolverName } from '../../web/engine/solvers/profiles';
import { COMMAND_LINES } from './bad_inputs/command_lines';
import { MODEL_FILES } from './bad_inputs/model_files';
import {
  BATCH_CONFIGS,
  BINDINGS,
  COLLIDERS,
  ENGINES,
  PINS,
  SETTINGS_FILES,
} from './bad_inputs/settings_texts';

/** Words of the program about itself, which tell a user nothing. */
const CODE =
  /undefined|\bnull\b|NaN\b.*of|is not a function|is not iterable|Cannot |TypeError|RangeError|Invalid (typed )?array|out of bounds|\[object|=>|Unexpected token|\bat position\b|offset is out|Maximum call stack|internal error/;

interface BadInput {
  /** in one line */
  input: string;
  read: () => unknown;
}

const shown = (text: string): string => {
  const line = JSON.stringify(text).replace(/(\\u0000){4,}/g, (zeros) => `(${zeros.length / 6} zeros)`);
  return line.length > 240 ? `${line.slice(0, 237)}...` : line;
};

const wordsOf = (line: string): string[] =>
  line.match(/'[^']*'|\S+/g)!.map((word) => word.replace(/^'(.*)'$/, '$1'));

const fileOf = (name: string, content: string) => ({
  name,
  bytes: Uint8Array.from(content, (letter) => letter.charCodeAt(0)),
});

const KINDS: Record<string, BadInput[]> = {
  'command line': COMMAND_LINES.map((line) => ({ input: line, read: () => parseArguments(wordsOf(line)) })),
  pins: PINS.map((text) => ({ input: text, read: () => parsePins(text) })),
  colliders: COLLIDERS.map((text) => ({ input: text, read: () => parseColliders(text) })),
  engine: ENGINES.map(([solver, text]) => ({
    input: `${solver} ${text}`,
    read: () => engineValues(solver as SolverName, text),
  })),
  'configuration of a batch': BATCH_CONFIGS.map((text) => ({
    input: shown(text),
    read: () => readBatchConfig(text, 'batch.json'),
  })),
  'settings file': SETTINGS_FILES.map((text) => ({
    input: shown(text),
    read: () => readSettingsFile('a.json', text),
  })),
  binding: BINDINGS.map((text) => ({ input: shown(text), read: () => readBinding('a.json', text) })),
  model: MODEL_FILES.map(([name, content, told]) => ({
    input: `${name} ${told ?? shown(content)}`,
    read: () => openModel([fileOf(name, content)]),
  })),
};

/** The sentence that an input gets; null where it is taken. */
async function sentenceOf({ read }: BadInput): Promise<string | null> {
  try {
    await read();
    return null;
  } catch (error) {
    const { code, line } = describeFailure(error);
    expect(code, line).toBe(EXIT.badInput);
    return line;
  }
}

describe('bad inputs', () => {
  const listed: string[] = [];
  const sentences = new Set<string>();

  it.each(Object.entries(KINDS))('of %s get one sentence each', async (kind, inputs) => {
    const names = inputs.map(({ input }) => input);
    expect(names.filter((name, i) => names.indexOf(name) < i)).toEqual([]);
    const taken: string[] = [];
    for (const bad of inputs) {
      const sentence = await sentenceOf(bad);
      if (sentence === null) {
        taken.push(bad.input);
        continue;
      }
      // What is quoted from the input is not the program's.
      const own = sentence.replace(/"[^"]*"/g, '""').replace(bad.input, '');
      expect.soft(own, bad.input).not.toMatch(CODE);
      expect.soft(sentence, bad.input).toMatch(/[.?]$/);
      expect.soft(sentence.length, bad.input).toBeLessThan(700);
      sentences.add(sentence);
      listed.push(`${kind}: ${bad.input}\n    ${sentence}`);
    }
    expect(taken).toEqual([]);
  });

  it('are at least 300, and their sentences are the reviewed ones', async () => {
    expect(listed.length).toBeGreaterThanOrEqual(300);
    await expect(`${listed.join('\n')}\n`).toMatchFileSnapshot('bad_inputs/sentences.txt');
  });

  it('are as many as the documents say', () => {
    const text = readFileSync(new URL('../../docs/reliability.md', import.meta.url), 'utf8');
    expect(text).toContain(`${listed.length} command lines, settings,`);
    expect(text).toContain(`${sentences.size} different sentences`);
  });
});
