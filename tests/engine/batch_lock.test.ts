/** The lock of a batch on the folder of its results. */

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { hostname, tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { takeLock } from '../../web/cli/batch/lock';

let folder: string;
const lock = () => join(folder, 'lock.json');
const endedProcess = () => spawnSync(process.execPath, ['-e', '']).pid;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'limber-lock-'));
});

afterEach(() => {
  rmSync(folder, { recursive: true });
});

it('names its owner while it is locked, and leaves nothing behind', () => {
  const unlock = takeLock(folder, 'out');
  expect(JSON.parse(readFileSync(lock(), 'utf8'))).toEqual({ host: hostname(), process: process.pid });
  expect(readdirSync(folder)).toEqual(['lock.json']);
  unlock();
  expect(readdirSync(folder)).toEqual([]);
});

it('is taken over from a process that has ended, and where the file is damaged', () => {
  for (const left of [JSON.stringify({ host: hostname(), process: endedProcess() }), '', '{"host":']) {
    writeFileSync(lock(), left);
    takeLock(folder, 'out')();
    expect(readdirSync(folder)).toEqual([]);
  }
});

it('stays with a process at work, here or on another machine', () => {
  for (const owner of [
    { host: hostname(), process: process.ppid },
    { host: 'elsewhere', process: endedProcess() },
  ]) {
    writeFileSync(lock(), JSON.stringify(owner));
    expect(() => takeLock(folder, 'out')).toThrow(
      `Another batch is at work on out (process ${owner.process} on ${owner.host}): wait for it, or remove ${lock()} if it has ended.`,
    );
    expect(JSON.parse(readFileSync(lock(), 'utf8'))).toEqual(owner);
  }
});

it('is not released by a process that has lost it', () => {
  const unlock = takeLock(folder, 'out');
  writeFileSync(lock(), JSON.stringify({ host: hostname(), process: process.ppid }));
  unlock();
  expect(existsSync(lock())).toBe(true);
});

it('says in a sentence where it cannot be written, and leaves no draft', () => {
  const missing = join(folder, 'missing');
  expect(() => takeLock(missing, 'out')).toThrow(
    `${join(missing, 'lock.json')} cannot be written: there is no such file.`,
  );
});
