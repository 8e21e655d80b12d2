/** The text of --help, within 100 columns. */

import { VERSION } from '../engine/core/version';
import { COMMAND_SPECS, COMMANDS, flagsOf } from './flags';
import type { Command, Flag } from './flags';

const WIDTH = 100;
const GROUPS: Record<string, string> = {
  target: 'Target',
  method: 'Method',
  motion: 'Motion',
  solver: 'Solver',
  simulation: 'Simulation',
  material: 'Material',
  batch: 'Batch',
  output: 'Output',
  common: 'Common',
};

export function helpText(command: Command | null): string {
  return command === null ? overview() : commandHelp(command);
}

function usageOf(command: Command): string {
  return `limber ${command} ${COMMAND_SPECS[command].operands.join(' ')} [options]`;
}

function overview(): string {
  const usages = COMMANDS.map((command) => {
    const { operands, summary } = COMMAND_SPECS[command];
    return `  limber ${command} ${operands.join(' ')}`.padEnd(31) + summary;
  });
  return [
    `Limber ${VERSION}: meshes with few triangles that still bend right.`,
    '',
    ...usages,
    '',
    'IN, A and B can be GLB, glTF (with its files beside it), OBJ, STL, PLY, OFF, or a ZIP of one with',
    'its files. OUT can be GLB, glTF, OBJ, PLY, or a ZIP of one, chosen by the ending of its name.',
    'limber help COMMAND (or limber COMMAND --help) lists the options of a command; limber completion',
    'bash|zsh|fish prints a completion script for that shell.',
    '',
    'A file can be -, but not in a batch: that is stdin for IN, A or B, and stdout for OUT.',
    '',
    'Exit codes: 0 done, 1 bad input or option, 2 a requested target was missed (OUT is written',
    'anyway; --soft makes it 0), 3 internal error.',
  ].join('\n');
}

function commandHelp(command: Command): string {
  const flags = flagsOf(command);
  const sections = Object.entries(GROUPS).flatMap(([group, title]) => {
    const members = flags.filter((flag) => flag.group === group);
    return members.length > 0 ? ['', title, ...members.flatMap(flagLines)] : [];
  });
  return [usageOf(command), COMMAND_SPECS[command].summary, ...sections].join('\n');
}

function flagLines({ name, value, help }: Flag): string[] {
  const head = `  --${name}${value ? ` ${value}` : ''}`;
  const indent = 30;
  const [first, ...others] = wrap(help, WIDTH - indent);
  const opening = head.length < indent ? [head.padEnd(indent) + first] : [head, ' '.repeat(indent) + first];
  return [...opening, ...others.map((line) => ' '.repeat(indent) + line)];
}

function wrap(text: string, width: number): string[] {
  const lines = [''];
  for (const word of text.split(' ')) {
    const line = lines[lines.length - 1];
    if (line !== '' && line.length + word.length >= width) lines.push(word);
    else lines[lines.length - 1] = line === '' ? word : `${line} ${word}`;
  }
  return lines;
}
