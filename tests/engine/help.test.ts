/** What --help says of a flag in one command and not in another. */

import { expect, it } from 'vitest';
import { flagsOf } from '../../web/cli/flags';
import type { Command } from '../../web/cli/flags';
import { helpText } from '../../web/cli/help';

const helpOf = (command: Command, name: string): string =>
  flagsOf(command).find((flag) => flag.name === name)!.help;

it('names the flags that limber tune cannot do without, and no default for them', () => {
  for (const name of ['solver', 'settings']) {
    expect(helpOf('tune', name)).toMatch(/^Has to be given\. /);
    expect(helpOf('tune', name)).not.toContain('Default');
    expect(helpOf('optimize', name)).not.toContain('Has to be given');
  }
});

it('says what limber modes does with modes, and has no flags for combining them', () => {
  expect(helpOf('modes', 'mode')).toMatch(/^Elastic modes that --shapes writes: .* Default: all\.$/);
  expect(helpOf('optimize', 'mode')).toMatch(/^Elastic modes that guide the collapses: /);
  for (const name of ['mode-weights', 'p', 'strain-threshold'])
    expect(flagsOf('modes').map((flag) => flag.name)).not.toContain(name);
});

it('says what is printed with --quiet, and what - is for each operand', () => {
  expect(helpOf('optimize', 'quiet')).toBe('Print nothing but errors and missed targets.');
  expect(helpText(null)).toContain('that is stdin for IN, A or B, and stdout for OUT.');
});
