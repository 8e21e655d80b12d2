/** Lists what a command would write, after all checks but without the work. */

import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { sum } from '../engine/core/mesh';
import { openAnyModel, openModel } from '../engine/document/open';
import type { OpenModel } from '../engine/document/open';
import { chosenBodies } from '../engine/body/selection';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import type { Command } from './flags';
import { followLinks, isSpecial } from './output_files/identity';
import { checkModelOutputs, checkPassedOn } from './output_files/model_outputs';
import { checkRoom, sizeOfModel } from './output_files/outputs';
import type { Output } from './output_files/outputs';
import { withoutYielded } from './output_files/preset_compression';
import { STAGES } from '../engine/stages/stages';
import { prepareFile, startSession } from './session';
import type { Session } from './session';
import { shownName, shownOutput, STANDARD } from './standard';
import { clearProgress } from './terminal';
import { counted, grouped } from '../engine/core/words';
import { plain } from './words';

export async function runDry(args: Arguments): Promise<number> {
  if (args.command === 'simulate') (await import('./simulate')).readCarried(args);
  const session = await startSession(args);
  const { checked } = session;
  const { files, outputs } = checked;
  const lines: string[] = [];
  const companions: string[] = [];
  const models = new Map<string, OpenModel>();
  for (const [path, sources] of files) {
    const model = await (args.command === 'optimize' ? openAnyModel(sources) : openModel(sources));
    models.set(path, model);
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
  const [first, second] = args.operands.map((path) => models.get(path));
  if (first!.bodies.length > 0) await BODY_CHECKS[args.command]?.(session, first!, second);
  clearProgress();
  for (const output of outputs) lines.push(`would write ${describeOutput(output)}`);
  for (const companion of companions) lines.push(`would write ${companion}, which belongs to OUT`);
  if (outputs.length === 0) lines.push('would write no file');
  process.stdout.write(`${plain(lines.join('\n'))}\n`);
  return EXIT.done;
}

type BodyCheck = (session: Session, first: OpenModel, second?: OpenModel) => Promise<void> | void;

/** What each command refuses of the bodies before it solves anything: settings that name what is not there, and pairs that are none. */
const BODY_CHECKS: Partial<Record<Command, BodyCheck>> = {
  optimize: (session, model) => {
    const { usable } = prepareFile(session, model);
    for (const { run } of usable) run.get(STAGES.constraints, session.args.settings);
  },
  modes: (session, model) => {
    const { usable } = prepareFile(session, model);
    for (const { run } of usable) run.get(STAGES.pinned, session.args.settings);
  },
  compare: async (session, first, second) => {
    (await import('./compare')).preparePairs(session, first, second!);
  },
  tune: async (session, first, second) => {
    (await import('./tune')).prepareTuning(session, first, second!);
  },
  simulate: async (session, first, second) => {
    const { prepareSides, readCarried, setUpMotions } = await import('./simulate');
    setUpMotions(session, prepareSides(session, first, second ?? null), readCarried(session.args));
  },
};

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
  return existsSync(end) ? `${what}${leads}, replacing the existing file` : `${what}${leads}`;
}
