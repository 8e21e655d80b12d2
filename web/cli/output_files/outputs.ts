/** The files that a command is going to write, and whether it may: all that can be known is known before the work. */

import { accessSync, constants, existsSync, statfsSync, statSync } from 'node:fs';
import { dirname } from 'node:path';
import { sum } from '../../engine/core/mesh';
import { grouped } from '../../engine/core/words';
import type { OpenModel } from '../../engine/document/open';
import { formOfName } from '../../engine/document/write/output_form';
import { isOwnFile } from './own_files';
import type { Arguments } from '../arguments';
import { UsageError } from '../failure';
import { followLinks, identityOf, isSpecial } from './identity';
import { levelFiles } from '../levels';
import { STANDARD } from '../standard';

export interface Output {
  /** as the user wrote it */
  path: string;
  /** the operand or flag that names it */
  flag: string;
  /** whether it is a model: a GLB, or of any format that can be written */
  isGlb: boolean;
  isAnyFormat?: true;
  /** what it can hold: how often all numbers and pictures of the model, and how often the positions of its bodies */
  capacity: { model: number; positions: number };
}

/** What a model can make of an output, in bytes. */
export interface ModelSize {
  /** all numbers and pictures, decoded: what a GLB of it takes, but for its JSON */
  model: number;
  positions: number;
}

/** At most 60 frames and the rest shape. */
const RECORDED = 61;
/** Some 100 letters for the 12 bytes of a position: a settings file has numbers as text and the triangles between them. */
const AS_TEXT = 8;

/** All that the command writes besides stdout. */
export function outputsOf(args: Arguments): Output[] {
  const { command, operands, settings } = args;
  const glb = (path: string, flag: string, model = 1, positions = 0): Output => ({
    path,
    flag,
    isGlb: true,
    capacity: { model, positions },
  });
  const text = (path: string, flag: string, positions: number): Output => ({
    path,
    flag,
    isGlb: false,
    capacity: { model: 0, positions },
  });
  const anyModel = (path: string, flag: string): Output => ({ ...glb(path, flag), isAnyFormat: true });
  const models = command === 'optimize' ? [anyModel(operands[1], 'OUT')] : [];
  const levels = levelFiles(args).map((path) => anyModel(path, 'a level of --lods'));
  const optional: [string | null, (path: string) => Output][] = [
    [args.shapes, (path) => glb(path, '--shapes', 1, settings.modeCount)],
    [args.record, (path) => glb(path, '--record', 0, RECORDED)],
    [command === 'optimize' ? args.bind : null, (path) => text(path, '--bind', AS_TEXT)],
    [command === 'simulate' ? null : args.settingsFile, (path) => text(path, '--settings', AS_TEXT)],
  ];
  const named = optional.flatMap(([path, output]) => (path === null ? [] : [output(path)]));
  return [...models, ...levels, ...named, ...args.reports.map((path) => text(path, '--report', 0))];
}

/**
 * Throws UsageError where an output is not to be written: over what is read, over another output, over a file of the user's
 * own without --force, or where the system does not allow it. `inputs`: paths of all files that are read or belong to them.
 */
export function checkOutputs(outputs: Output[], inputs: string[], force: boolean): void {
  const files = outputs.filter(({ path }) => path !== STANDARD);
  for (const output of files) checkFolder(output);
  const read = new Map(inputs.map((path) => [identityOf(path), path]));
  const written = new Map<string, Output>();
  for (const output of files) {
    const identity = identityOf(output.path);
    const input = read.get(identity);
    if (input !== undefined) throw new UsageError(describeInput(output, input));
    const other = written.get(identity);
    if (other)
      throw new UsageError(
        `${named(other)} and ${named(output)} are the same file: choose another name for one of them.`,
      );
    written.set(identity, output);
    if (!force) checkOwner(output);
  }
}

const named = ({ path, flag }: Output): string => (flag === 'OUT' ? path : `${path} (${flag})`);

function describeInput({ path, flag }: Output, input: string): string {
  const what = flag === 'OUT' ? path : `${path}, ${flag.startsWith('-') ? `the file of ${flag}` : flag},`;
  const where = flag.startsWith('a level') ? ' for OUT' : '';
  return path === input
    ? `${what} is also the input: choose another name${where}.`
    : `${what} leads to ${input}, which belongs to the input: choose another name${where}.`;
}

/** Throws UsageError where a model is to have a name that says no format that can be written. */
export function checkEndings(outputs: Output[], isFormatAsked: boolean): void {
  for (const { path, isGlb, isAnyFormat } of outputs) {
    if (path === STANDARD || !isGlb) continue;
    if (!isAnyFormat && !path.toLowerCase().endsWith('.glb'))
      throw new UsageError(`${path} is not a .glb: give a name that ends in .glb.`);
    if (isAnyFormat && !isFormatAsked && formOfName(path, 'glb') === null)
      throw new UsageError(
        `${path} does not end in the name of a format that can be written: give a name that ends in .glb, .gltf, .obj, .ply or .zip.`,
      );
  }
}

/** Whether the folder is there and lets files be made, and an old file be changed. */
function checkFolder({ path }: Output): void {
  const end = followLinks(path);
  const folder = dirname(end);
  const shown = existsSync(dirname(path)) ? folder : dirname(path);
  if (!existsSync(folder)) throw new UsageError(`The folder ${shown} does not exist: create it first.`);
  const old = statSync(end, { throwIfNoEntry: false });
  if (old?.isDirectory()) throw new UsageError(`${path} is a folder: name a file.`);
  if (old && !isWritable(end))
    throw new UsageError(`${path} is write-protected: make it writable, or name another file.`);
  if (!isSpecial(end) && !isWritable(folder))
    throw new UsageError(`${path} cannot be written: its folder is write-protected, so choose another one.`);
}

/** Whether the system lets a file be changed, or files be made in a folder. */
export function isWritable(path: string): boolean {
  try {
    accessSync(path, constants.W_OK);
    return true;
  } catch {
    return false;
  }
}

function checkOwner({ path }: Output): void {
  const end = followLinks(path);
  if (existsSync(end) && !isSpecial(end) && !isOwnFile(end))
    throw new UsageError(
      `${path} exists and was not written by limber: name another file, or replace it with --force.`,
    );
}

/** Smaller than any report of a scene. */
const SMALLEST = 1 << 20;

/** Throws UsageError where a disk has less room than the outputs can take. */
export function checkRoom(outputs: Output[], size: ModelSize, roomOf = freeBytes): void {
  const needed = new Map<string, { bytes: number; free: number }>();
  for (const { path, capacity } of outputs) {
    if (path === STANDARD || isSpecial(followLinks(path))) continue;
    const folder = dirname(followLinks(path));
    const room = roomOf(folder);
    if (room === null) continue;
    const { bytes = 0 } = needed.get(room.disk) ?? {};
    const all = bytes + Math.max(SMALLEST, capacity.model * size.model + capacity.positions * size.positions);
    needed.set(room.disk, { bytes: all, free: room.free });
    if (all > room.free)
      throw new UsageError(
        `The disk of ${folder} has ${megabytes(room.free, Math.floor)} MB left, but the result can need ${megabytes(all, Math.ceil)} MB: free some space, or choose another folder.`,
      );
  }
}

export function sizeOfModel({ document, bodies }: OpenModel): ModelSize {
  const root = document.getRoot();
  const numbers = root.listAccessors().map((accessor) => accessor.getArray()?.byteLength ?? 0);
  const pictures = root.listTextures().map((texture) => texture.getImage()?.byteLength ?? 0);
  const positions = sum(bodies.map((body) => body.positions.byteLength));
  return { model: sum(numbers) + sum(pictures), positions };
}

/** In tenths below ten, so that what is left is never as much as what it takes. */
function megabytes(bytes: number, round: (value: number) => number): string {
  const value = bytes / 2 ** 20;
  return value < 10 ? (round(10 * value) / 10).toFixed(1) : grouped(round(value));
}

interface Room {
  /** the same for folders on one disk */
  disk: string;
  /** bytes that this user can still write */
  free: number;
}

/** Null where the file system does not tell. */
function freeBytes(folder: string): Room | null {
  try {
    const { bavail, bsize, blocks } = statfsSync(folder);
    return blocks === 0 ? null : { disk: String(statSync(folder).dev), free: bavail * bsize };
  } catch {
    return null;
  }
}
