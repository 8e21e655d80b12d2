/** limber modes IN */

import { basename } from 'node:path';
import { droppedByExport, exportGlb } from '../engine/document/export';
import { shapeTargets } from '../engine/document/shapes';
import { describeSize, describeSolve } from '../engine/body/health';
import { resolveModes } from '../engine/settings/options';
import type { Settings } from '../engine/settings/options';
import { exportedMesh, findModes, materialOf, startStopwatch } from '../engine/stages/pipeline';
import type { PreparedBody } from '../engine/stages/pipeline';
import type { ModeSet } from '../engine/core/core';
import { findPins } from '../engine/body/pins';
import { modesReport, startReport } from '../engine/report/report';
import type { Report } from '../engine/report/report';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import { checkOutput, writeWhole } from './files';
import { finish, openFile, prepareBodies, startSession, usable } from './session';
import { plural, table } from './words';

export async function runModes(args: Arguments): Promise<number> {
  const [input] = args.operands;
  if (args.shapes !== null) checkOutput(args.shapes, input);
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const { settings } = args;
  const model = await openFile(session, input);
  const load = stopwatch();
  const prepared = prepareBodies(session, model);
  for (const body of usable(prepared)) {
    const size = describeSize(body.diagonal * materialOf(body, settings).unit);
    if (size !== '') session.warnings.push(`${body.body.name}: ${size}`);
  }
  const weld = stopwatch();
  const sets = prepared.map((body) => {
    session.activity = body?.body.name ?? '';
    if (!body) return null;
    return findModes(session.core, body, settings, findPins(settings.pins, model.document, body));
  });
  const solved = stopwatch();
  if (args.shapes !== null) {
    const shown = prepared.map((body, i) => (body ? shapesOf(args, body, sets[i]!) : null));
    writeWhole(args.shapes, await exportGlb(model, shown, { fields: false }));
    const dropped = droppedByExport(model, true);
    if (dropped.length > 0) session.warnings.push(`${args.shapes} leaves out ${dropped.join(', ')}`);
  }
  const used: Partial<Settings> & { mesh?: string } = { ...settings };
  delete used.method; // it only keeps `auto` from meaning the paper's model
  if (args.mesh !== null) used.mesh = args.mesh;
  const report = startReport(session.core, 'modes', used, usable(prepared));
  Object.assign(report, modesReport(sets.filter((set) => set !== null)));
  session.warnings.push(...describeSolve(report.modes!, report.solve!.coarseVertices ?? 0));
  report.timings = { load, weld, modes: solved, export: stopwatch(), total: total() };
  finish(session, report, modesText(args, report));
  return EXIT.done;
}

function shapesOf({ settings }: Arguments, prepared: PreparedBody, modes: ModeSet) {
  const ordinals = resolveModes(settings).map((mode) => mode - 1);
  const targets = shapeTargets(prepared.mesh, modes, ordinals, prepared.diagonal);
  return { ...exportedMesh(prepared), targets };
}

function modesText(
  { operands, shapes }: Arguments,
  { modes, components, zeroModes, model, timings }: Report,
): string {
  const isNominal = model === 'laplacian';
  const isAlong = modes!.some(({ along }) => along !== undefined);
  const many = components!.length > 1;
  const header = [
    'mode',
    'name',
    ...(isAlong ? ['along'] : []),
    'frequency',
    'omega',
    'residual',
    ...(many ? ['part'] : []),
  ];
  const rows = modes!.map(({ name, along, frequency, omega, residual, component }, i) => [
    String(i + 1),
    name,
    ...(isAlong ? [`${along} axis`] : []),
    `${frequency.toPrecision(4)} Hz`,
    `${omega.toPrecision(4)} rad/s`,
    residual.toExponential(1),
    ...(many ? [String(component + 1)] : []),
  ]);
  const parts = many ? `, ${plural(components!.length, 'part', 'parts')}` : '';
  const zero = `${zeroModes!.found} of ${zeroModes!.expected} zero modes found`;
  const heading = `${basename(operands[0])}: ${model} model${parts}, ${zero}, ${timings.modes.toFixed(1)} s`;
  const nominal = isNominal
    ? ['Frequencies of the laplacian model are nominal: only their proportions mean something.']
    : [];
  return [heading, table([header, ...rows]), ...nominal, ...(shapes !== null ? [`-> ${shapes}`] : [])].join(
    '\n',
  );
}
