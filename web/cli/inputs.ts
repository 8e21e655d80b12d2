/** The inputs of a command, and the check of its outputs against them, before any work. */

import { existsSync } from 'node:fs';
import type { SourceFile } from '../engine/document/open';
import { staysObj } from '../engine/document/write/output_form';
import type { Arguments } from './arguments';
import { UsageError } from './failure';
import { readModelFiles } from './files';
import { checkEndings, checkOutputs, outputsOf } from './output_files/outputs';
import type { Output } from './output_files/outputs';
import { checkStandard, STANDARD } from './standard';

export interface CheckedFiles {
  /** by operand: the model with its companions */
  files: Map<string, SourceFile[]>;
  outputs: Output[];
  /** paths of all files that are read or belong to them */
  inputs: string[];
  /** whether stdout has the model, so that words go to stderr */
  takesStdout: boolean;
}

/** Throws UsageError. */
export async function checkFiles(args: Arguments): Promise<CheckedFiles> {
  const { command, operands, settings, reports, force } = args;
  const outputs = outputsOf(args);
  const models = outputs.filter(({ isGlb }) => isGlb).map(({ path }) => path);
  const inputs = command === 'optimize' ? operands.slice(0, 1) : operands;
  if (args.from !== null && !inputs.includes(STANDARD))
    throw new UsageError(
      '--from applies to a model read from stdin: give - as its name, or leave --from out.',
    );
  const others = outputs.filter(({ isGlb, flag }) => !isGlb && flag !== '--report').map(({ path }) => path);
  checkStandard({ inputs, models, reports, others, levels: settings.lods.length });
  checkEndings(outputs, settings.format !== 'auto');
  const files = new Map<string, SourceFile[]>();
  const carries = command === 'optimize' && staysObj(operands[1], settings.format);
  const paths: string[] = otherInputs(args);
  for (const input of inputs) {
    const model = await readModelFiles(input, args.from, carries);
    files.set(input, model.files);
    paths.push(...model.paths);
  }
  checkOutputs(outputs, paths, force);
  return { files, outputs, inputs: paths, takesStdout: models.includes(STANDARD) };
}

/** Files that are read besides models. */
function otherInputs({ command, bind, settingsFile, engineFile }: Arguments): string[] {
  const read = command === 'simulate' ? [bind, settingsFile, engineFile] : [engineFile];
  return read.filter((path) => path !== null).filter((path) => existsSync(path));
}
