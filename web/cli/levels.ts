/** Further levels of detail of limber optimize: one file each. */

import { resolve } from 'node:path';
import type { LevelReport } from '../engine/report/result_report';
import type { StoppedBody } from '../engine/report/stop_report';
import type { FileOutput } from '../engine/stages/file_output';
import type { Arguments } from './arguments';
import { UsageError } from './failure';
import { checkFolder, writeWhole } from './files';

export interface WrittenLevel {
  report: LevelReport;
  /** per body, for the sentences about missed targets */
  bodies: StoppedBody[];
}

/** The files of the levels beside OUT.glb: OUT_lod1.glb and so on. */
export const levelFiles = ({ operands, settings }: Arguments): string[] =>
  settings.lods.map((_, i) => operands[1].replace(/\.glb$/i, `_lod${i + 1}$&`));

/** Refuses files that could not be written, before any work. */
export function checkLevels(args: Arguments): void {
  for (const file of levelFiles(args)) {
    if (resolve(file) === resolve(args.operands[0]))
      throw new UsageError(`${file}, a level of --lods, is also the input: choose another name for OUT.`);
    checkFolder(file);
  }
}

/** Writes every level of --lods. */
export async function writeLevels(args: Arguments, output: FileOutput): Promise<WrittenLevel[]> {
  const written: WrittenLevel[] = [];
  for (const [i, file] of levelFiles(args).entries()) {
    const { bytes, bodies, report } = await output.level(i);
    writeWhole(file, bytes);
    written.push({ report: { file, ...report }, bodies });
  }
  return written;
}
