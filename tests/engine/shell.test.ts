/** The manual page and the completion of shells. */

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { COMMANDS, flagsOf } from '../../web/cli/flags';
import { completionScript, wordsOf } from '../../web/cli/shell/completion';
import type { Shell } from '../../web/cli/shell/completion';
import { manPage } from '../../web/cli/shell/man_page';

const hasProgram = (name: string) => spawnSync(name, ['--version']).status === 0;

it('the manual page is current', () => {
  // node scripts/docs/man-page.mjs writes it.
  expect(readFileSync(join(import.meta.dirname, '../../docs/limber.1'), 'utf8')).toBe(manPage());
});

it('the manual page has every flag of every command, in lines that are no requests by accident', () => {
  const page = manPage();
  for (const command of COMMANDS)
    for (const { name } of flagsOf(command)) expect(page).toContain(`\\-\\-${name.replaceAll('-', '\\-')}`);
  expect(page.split('\n').filter((line) => /^[.'](?!TH|SH|SS|TP|B |BR |br)/.test(line))).toEqual([]);
});

describe('completion', () => {
  const scratch = mkdtempSync(join(tmpdir(), 'limber-shell-'));
  afterAll(() => rmSync(scratch, { recursive: true }));

  function scriptFile(shell: Shell): string {
    const path = join(scratch, shell);
    writeFileSync(path, completionScript(shell));
    return path;
  }

  /** What bash offers for the last of the words. */
  function offered(...words: string[]): string[] {
    const script = `${completionScript('bash')}
COMP_WORDS=(${words.map((word) => `'${word}'`).join(' ')}); COMP_CWORD=${words.length - 1}
_limber; printf '%s\\n' "\${COMPREPLY[@]}"`;
    return spawnSync('bash', ['-c', script], { encoding: 'utf8' }).stdout.trim().split('\n');
  }

  it('offers commands, flags and the words that flags take', () => {
    expect(offered('limber', 'o')).toEqual(['optimize']);
    expect(offered('limber', 'batch', '--jo')).toEqual(['--jobs']);
    expect(offered('limber', 'optimize', 'a.glb', '--method', '')).toEqual(['limber', 'paper', 'qem']);
    expect(offered('limber', 'optimize', 'a.glb', '--format', 'obj')).toEqual(['obj', 'obj.zip']);
    expect(offered('limber', 'completion', 'f')).toEqual(['fish']);
    expect(offered('limber', 'inspect', '--jo')).toEqual(['']);
    expect(offered('limber', '--')).toEqual(['--help', '--version']);
    expect(offered('limber', '')).not.toContain('--help');
    expect(offered('limber', 'help', 'o')).toEqual(['optimize']);
    expect(offered('limber', 'help', 'c')).toEqual(['compare', 'completion']);
    expect(offered('limber', 'completion', '--')).toEqual(['--help']);
  });

  it('knows the words of flags that take words', () => {
    const flag = (value?: string) => wordsOf({ name: 'x', value, help: '', group: '' });
    expect([flag('a|b-c'), flag('FILE|-'), flag('N'), flag()]).toEqual([['a', 'b-c'], [], [], []]);
  });

  for (const shell of ['zsh', 'fish'] as Shell[]) {
    it(`has every flag in the script of ${shell}`, () => {
      const script = completionScript(shell);
      const flags = COMMANDS.flatMap(flagsOf);
      const missing = flags.filter(({ name }) => !new RegExp(`(--|-l )${name}\\b`).test(script));
      expect(missing).toEqual([]);
    });

    it.skipIf(!hasProgram(shell))(`is a script that ${shell} reads`, () => {
      const { status, stderr } = spawnSync(shell, ['-n', scriptFile(shell)], { encoding: 'utf8' });
      expect([status, stderr]).toEqual([0, '']);
    });
  }

  it.skipIf(!hasProgram('fish'))('offers the same in fish', () => {
    const offeredInFish = (line: string) => {
      const words = `source ${scriptFile('fish')}; complete -C "${line}"`;
      const { stdout } = spawnSync('fish', ['--no-config', '-c', words], { encoding: 'utf8' });
      return stdout.split('\n').map((text) => text.split('\t')[0]);
    };
    expect(offeredInFish('limber op')).toContain('optimize');
    expect(offeredInFish('limber batch --jo')).toContain('--jobs');
    expect(offeredInFish('limber optimize a.glb --method ')).toEqual(
      expect.arrayContaining(['limber', 'paper', 'qem']),
    );
  });
});
