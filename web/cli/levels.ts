/** Further levels of detail of limber optimize: one file each, from the histories that are there. */

import { resolve } from 'node:path';
import type { MeshAt } from '../engine/core/core';
import { exportGlb } from '../engine/document/export';
import type { ExportedBody } from '../engine/document/export';
import type { OpenModel } from '../engine/document/open';
import type { Held } from '../engine/body/constraints';
import { levelAt } from '../engine/stages/optimize';
import type { OptimizedBody } from '../engine/stages/optimize';
import { exportedBody, measureResult } from '../engine/stages/pipeline';
import { meshReport, stopReport, worstSurface } from '../engine/report/report';
import type { LevelReport, StoppedBody } from '../engine/report/report';
import { facesByRatio } from '../engine/stages/face_shares';
import { calibrationOf } from '../engine/motion/simulation';
import type { Arguments } from './arguments';
import { UsageError } from './failure';
import { checkFolder, writeWhole } from './files';
import type { Session } from './session';

/** What has been optimized of one body, and what it holds. */
export interface Finished {
  body: OptimizedBody;
  held: Held;
}

export interface WrittenLevel {
  report: LevelReport;
  /** what it is made of, for words about what was missed */
  bodies: StoppedBody[];
}

/** The files of the levels beside OUT.glb: OUT_lod1.glb and on. */
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

/** What is written of a result, with the factor on its stiffness where that is asked. */
export function writtenBody(
  { core, args }: Session,
  { prepared, guidance, curvature }: OptimizedBody,
  result: MeshAt,
): ExportedBody {
  const exported = exportedBody(core, prepared, result, args.fields ? { guidance, curvature } : null);
  if (!args.settings.calibrate) return exported;
  return { ...exported, calibration: calibrationOf(core, prepared, result.mesh, args.settings) };
}

/** Writes every level of --lods; null is a body that stays as it is. */
export async function writeLevels(
  session: Session,
  model: OpenModel,
  finished: (Finished | null)[],
): Promise<WrittenLevel[]> {
  const files = levelFiles(session.args);
  const written: WrittenLevel[] = [];
  for (const [i, ratio] of session.args.settings.lods.entries())
    written.push(await writeLevel(session, model, finished, { ratio, file: files[i] }));
  return written;
}

async function writeLevel(
  session: Session,
  model: OpenModel,
  finished: (Finished | null)[],
  { ratio, file }: { ratio: number; file: string },
): Promise<WrittenLevel> {
  const { core, args } = session;
  const levels = finished.map((one) => {
    if (!one) return null;
    const { prepared, history } = one.body;
    const targetFaces = Math.max(1, facesByRatio(ratio, prepared.mesh.triangles.length / 3));
    const request = { settings: args.settings, targetFaces, ...one.held };
    const { result } = levelAt(core, prepared, history, request).fitted;
    return {
      exported: writtenBody(session, one.body, result),
      measured: measureResult(core, prepared, result),
      stopped: { faces: result.mesh.triangles.length / 3, targetFaces, history },
    };
  });
  const exported = levels.map((level) => level && level.exported);
  writeWhole(file, await exportGlb(model, exported, { fields: args.fields }));
  const done = levels.filter((level) => level !== null);
  const bodies = done.map(({ stopped }) => stopped);
  const output = meshReport(done.map(({ measured }) => measured));
  const surface = worstSurface(done.map(({ measured }) => measured.distance));
  return { report: { file, ratio, output, surface, stop: stopReport(bodies) }, bodies };
}
