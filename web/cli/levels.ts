/** Further levels of detail of limber optimize: one file each. */

import { basename } from 'node:path';
import type { SourceFile } from '../engine/document/open';
import { levelNames } from '../engine/document/write/output_form';
import type { LevelReport } from '../engine/report/result_report';
import type { StoppedBody } from '../engine/report/stop_report';
import type { FileOutput } from '../engine/stages/file_output';
import type { Arguments } from './arguments';
import { describeFailure } from './failure';

export interface WrittenLevel {
  report: LevelReport;
  /** per body, for the sentences about missed targets */
  bodies: StoppedBody[];
}

/** What became of the levels: those that are written, and why the next one is not. */
export interface WrittenLevels {
  written: WrittenLevel[];
  /** null: all are written */
  failure: { code: number; sentence: string } | null;
}

/** The files of the levels beside OUT.glb: OUT_lod1.glb and so on. */
export const levelFiles = (args: Pick<Arguments, 'operands' | 'settings'>): string[] =>
  args.settings.lodStyle === 'files' ? levelNames(args.operands[1], args.settings) : [];

/** Writes the levels of --lods by `save`, up to the first that fails; what is written stays. */
export async function writeLevels(
  args: Pick<Arguments, 'operands' | 'settings'>,
  output: Pick<FileOutput, 'level'>,
  save: (path: string, files: SourceFile[]) => void,
): Promise<WrittenLevels> {
  const written: WrittenLevel[] = [];
  for (const [i, file] of levelNames(args.operands[1], args.settings).entries()) {
    try {
      const { files, bodies, report } = await output.level(i, basename(file));
      if (files.length > 0) save(file, files);
      written.push({ report: { file, ...report }, bodies });
    } catch (error) {
      const { code, line } = describeFailure(error);
      const others = [args.operands[1], ...written.map(({ report }) => report.file)];
      const why = line.replace(/\.$/, '').replace(`${file} cannot be written: `, '');
      const sentence = `${file} is not written: ${why}; ${others.join(', ')} ${others.length === 1 ? 'is' : 'are'}`;
      return { written, failure: { code, sentence } };
    }
  }
  return { written, failure: null };
}
