/** What a command would write, after all checks and without the work. */

import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { sum } from '../engine/core/mesh';
import { openAnyModel, openModel } from '../engine/document/open';
import type { OpenModel } from '../engine/document/open';
import { chosenBodies } from '../engine/body/selection';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import { followLinks, isSpecial } from './output_files/identity';
import { checkFiles } from './inputs';
import { checkModelOutputs, checkPassedOn } from './output_files/model_outputs';
import { checkRoom, sizeOfModel } from './output_files/outputs';
import type { Output } from './output_files/outputs';
import { withoutYielded } from './output_files/preset_compression';
import { shownName, shownOutput, STANDARD } from './standard';
import { counted, grouped } from '../engine/core/words';
import { plain } from './words';

export async function runDry(args: Arguments): Promise<number> {
  const checked = await checkFiles(args);
  const { files, outputs } = checked;
  if (args.command === 'simulate') (await import('./simulate')).readCarried(args);
  const lines: string[] = [];
  const companions: string[] = [];
  for (const [path, sources] of files) {
    const model = await (args.command === 'optimize' ? openAnyModel(sources) : openModel(sources));
    checkRoom(outputs, sizeOfModel(model));
    lines.push(describeModel(args, path, model));
    if (args.command !== 'optimize') continue;
    const isEmpty = model.bodies.length === 0;
    if (isEmpty) checkPassedOn(args, model);
    const chosen = isEmpty ? [] : chosenBodies(model, args.settings);
    const yielded = withoutYielded(args, model);
    lines.push(...yielded.notes);
    const asked = { args: yielded.args, checked, isHosted: false };
    companions.push(...checkModelOutputs(asked, model, chosen).companions);
  }
  for (const output of outputs) lines.push(`would write ${describeOutput(output)}`);
  for (const companion of companions) lines.push(`would write ${companion}, which belongs to OUT`);
  if (outputs.length === 0) lines.push('would write no file');
  process.stdout.write(`${plain(lines.join('\n'))}\n`);
  return EXIT.done;
}

function describeModel({ settings }: Arguments, path: string, model: OpenModel): string {
  const { bodies, format } = model;
  const chosen = bodies.length === 0 ? [] : chosenBodies(model, settings);
  const faces = sum(chosen.map((i) => bodies[i].indices.length / 3));
  const of = chosen.length < bodies.length ? `${grouped(chosen.length)} of ` : '';
  const all = counted(bodies.length, 'body', 'bodies');
  return `${shownName(path)}: ${format.toUpperCase()}, ${of}${all}, ${counted(faces, 'face')}`;
}

function describeOutput({ path, flag }: Output): string {
  const what = flag === 'OUT' ? shownOutput(path) : `${shownOutput(path)} (${flag})`;
  if (path === STANDARD || isSpecial(path)) return what;
  const end = followLinks(path);
  const leads = end === resolve(path) ? '' : `, which leads to ${end}`;
  return existsSync(end) ? `${what}${leads}, in place of the file that is there` : `${what}${leads}`;
}
