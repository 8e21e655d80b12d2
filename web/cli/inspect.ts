/** limber inspect IN */

import { describeHealth } from '../engine/body/health';
import type { InspectedBody } from '../engine/body/prepared_body';
import { startStopwatch } from '../engine/core/stopwatch';
import type { Body, OpenModel } from '../engine/document/open';
import { counted, excerpt, grouped } from '../engine/core/words';
import { settingsOfCommand, startReport } from '../engine/report/report';
import { inspectBody } from '../engine/stages/prepared';
import { chosenBodies } from '../engine/body/selection';
import type { Arguments } from './arguments';
import { EXIT } from './failure';
import { finish, openFile, startSession } from './session';
import { table } from './words';

export async function runInspect(args: Arguments): Promise<number> {
  const total = startStopwatch();
  const stopwatch = startStopwatch();
  const session = await startSession(args);
  const model = await openFile(session);
  const load = stopwatch();
  const bodies = chosenBodies(model, args.settings).map((i) => model.bodies[i]);
  const inspected = bodies.map((body) => inspectBody(session.core, body, args.settings));
  const used = settingsOfCommand('inspect', args.settings);
  const report = startReport(session.core, 'inspect', used, inspected);
  report.timings = { load, inspect: stopwatch(), total: total() };
  finish(session, report, inspectText(model, bodies, inspected));
  return EXIT.done;
}

function inspectText(model: OpenModel, bodies: Body[], inspected: InspectedBody[]): string {
  const header = ['body', 'vertices', 'faces', 'parts', 'borders', 'genus', 'smallest angle', 'mean'];
  const rows = inspected.map((one, i) => bodyRow(bodies[i], one));
  const notes = inspected.flatMap(({ weld, inspection }, i) =>
    describeHealth(bodies[i], weld, inspection).map(({ text }) =>
      bodies.length > 1 ? `${bodies[i].name}: ${text}` : text,
    ),
  );
  const heading = `${model.name}: ${model.format.toUpperCase()}, ${counted(model.bodies.length, 'body', 'bodies')}`;
  return [heading, table([header, ...rows]), ...notes.map((note) => `- ${note}`)].join('\n');
}

function bodyRow({ name }: Body, { weld, quality }: InspectedBody): string[] {
  const { vertices, faces, components, boundaryLoops, genus } = weld.inspection;
  const degrees = (angle?: number) => (angle === undefined ? '-' : `${angle.toFixed(2)} deg`);
  const counts = [vertices, faces, components, boundaryLoops].map(grouped);
  return [
    excerpt(name),
    ...counts,
    genus === null ? '-' : grouped(genus),
    degrees(quality?.minAngle),
    degrees(quality?.meanMinAngle),
  ];
}
