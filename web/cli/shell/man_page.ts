/** The manual page of the command line, made from the table of flags; docs/limber.1 is what this returns. */

import { VERSION } from '../../engine/core/version';
import type { Flag } from '../flag';
import { COMMAND_SPECS, COMMANDS, flagsOf } from '../flags';
import type { Command } from '../flags';

const EXIT_CODES = [
  ['0', 'Done, even if a default such as half of the faces was not reached.'],
  ['1', 'Bad input or option; in a batch, at least one asset failed.'],
  ['2', 'A target given as a number or limit was missed; the file is written anyway.'],
  ['3', 'Internal error.'],
];

const DESCRIPTION = `Limber simplifies meshes so that they still move right: it predicts how a soft body or a piece of cloth will bend, measures
where it strains, and collapses edges so that motion and shape survive. It reads GLB, glTF, OBJ, STL, PLY and OFF, and
ZIPs of them. IN and OUT can be -, which means stdin and stdout. Limber never overwrites the input, the files that belong to
it, or, without --force, a file that it has not written itself. Progress and warnings go to stderr.`;

/** The text in the macros of man(7). */
export function manPage(): string {
  return [
    `.TH LIMBER 1 "" "Limber ${VERSION}" "User Commands"`,
    '.SH NAME',
    'limber \\- meshes with few triangles that still bend right',
    '.SH SYNOPSIS',
    ...COMMANDS.flatMap((command) => ['.br', `.B limber ${command}`, roff(operandsOf(command))]),
    '.br',
    '.B limber completion',
    'bash|zsh|fish',
    '.br',
    '.B limber help',
    '[COMMAND]',
    '.SH DESCRIPTION',
    ...DESCRIPTION.split('\n').map(roff),
    '.SH COMMANDS',
    ...COMMANDS.flatMap(section),
    '.SH EXIT STATUS',
    ...EXIT_CODES.flatMap(([code, words]) => ['.TP', `.B ${code}`, roff(words)]),
    '.SH ENVIRONMENT',
    '.TP',
    '.B TERM',
    roff(
      'If it is dumb, no line of progress is redrawn. Output is never coloured, so NO_COLOR has no effect.',
    ),
    '',
  ].join('\n');
}

const operandsOf = (command: Command): string => `${COMMAND_SPECS[command].operands.join(' ')} [options]`;

function section(command: Command): string[] {
  return [
    `.SS limber ${command} ${roff(operandsOf(command))}`,
    roff(COMMAND_SPECS[command].summary),
    ...flagsOf(command).flatMap(entry),
  ];
}

const entry = ({ name, value, help }: Flag): string[] => [
  '.TP',
  `.BR ${roff(`--${name}`)}${value === undefined ? '' : ` " ${roff(value)}"`}`,
  roff(help),
];

/** Text whose letters the macros leave alone: dashes are dashes, and no line starts with a dot or an apostrophe. */
const roff = (text: string): string =>
  text
    .replaceAll('\\', '\\e')
    .replaceAll('-', '\\-')
    .replaceAll('"', '\\(dq')
    .replace(/^([.'])/, '\\&$1');
