/** The command lines in the documents' code blocks, run as they stand. */

import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { toObj, torus } from './support/shapes';

const root = join(import.meta.dirname, '..', '..');
const program = join(root, 'dist', 'cli', 'limber.mjs');
const folders: string[] = [];
const documents = ['README.md', 'docs/recipes/README.md'].concat(
  readdirSync(join(root, 'docs'))
    .filter((name) => name.endsWith('.md'))
    .map((name) => `docs/${name}`),
);

/** Fenced or indented lines that call limber, as words. Lines with names in capitals are forms, not commands. */
function commandsOf(text: string): string[][] {
  const called = /^(?: {4})?(?:npm run --silent limber -- |npx limber |limber )([a-z]+ .*)$/;
  const isCommand = (line: string): boolean => called.test(line) && !/ (?:FOLDER|FILE|OUT)\b/.test(line);
  return text
    .split('\n')
    .filter(isCommand)
    .map((line) => called.exec(line)![1])
    .filter((line) => /^(optimize|tune|modes|compare|simulate|inspect|batch) /.test(line))
    .map((line) => line.match(/'[^']*'|\S+/g)!.map((word) => word.replaceAll("'", '')));
}

/** The files that a command reads. */
function inputsOf([command, ...words]: string[]): string[] {
  const options = words.findIndex((word) => word.startsWith('--'));
  const operands = options < 0 ? words : words.slice(0, options);
  if (command === 'optimize') return operands.slice(0, 1);
  return command === 'batch' ? ['assets/one.obj', 'assets/props/two.obj'] : operands;
}

const limber = (folder: string, words: string[]) =>
  spawnSync(process.execPath, [program, ...words], { cwd: folder, encoding: 'utf8' });

/** Makes an input that is not there yet; what is not an OBJ is made of one by limber. */
function makeInput(folder: string, name: string): void {
  const file = join(folder, name);
  if (existsSync(file)) return;
  mkdirSync(dirname(file), { recursive: true });
  if (name.endsWith('.obj')) return writeFileSync(file, toObj(torus(32, 16)));
  makeInput(folder, 'source.obj');
  const { status, stderr } = limber(folder, ['optimize', 'source.obj', name, '--ratio', '0.7']);
  if (status !== 0) throw new Error(stderr);
}

function startFolder(text: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'limber-documented-'));
  folders.push(folder);
  const config = /```json\n(\{\s+"schema": "limber-batch\/1"[^`]*)```/.exec(text);
  if (config) writeFileSync(join(folder, 'batch.json'), config[1]);
  return folder;
}

afterAll(() => folders.forEach((folder) => rmSync(folder, { recursive: true })));

const found = documents
  .map((name) => ({ name, text: readFileSync(join(root, name), 'utf8') }))
  .map(({ name, text }) => ({ name, text, commands: commandsOf(text) }))
  .filter(({ commands }) => commands.length > 0);

describe('command lines in documents', () => {
  it('are found', () => {
    expect(found.flatMap(({ commands }) => commands).length).toBeGreaterThan(12);
  });

  it.each(found)('of $name run', ({ text, commands }) => {
    const folder = startFolder(text);
    for (const words of commands) {
      for (const name of inputsOf(words)) makeInput(folder, name);
      const { status, stderr } = limber(folder, words);
      // Where so few faces are asked for that this coarse stand-in would change its shape, limber stops and says so.
      const isGuarded = status === 2 && stderr.includes('--max-deviation 0 lifts this');
      expect([words.join(' '), isGuarded ? 0 : status, stderr]).toEqual([words.join(' '), 0, stderr]);
    }
  });
});
