/** The tasks of the page, in order, and the conditions under which they are needed. */

import { effect, signal } from '@preact/signals';
import { faceCount } from '../../../engine/core/mesh';
import { STAGES } from '../../../engine/stages/stages';
import { exportSettings } from '../../worker/export_form';
import { sharesKey } from '../../worker/protocol';
import { canDrawFile, resultFileNow } from '../drawn_file';
import { exportedKey, exportRequest, genericKey, levelsKey } from '../export_request';
import { findPins } from '../find_pins';
import { compareMethods, comparison, comparisonTaskKey } from '../methods';
import { isReplayed } from '../replay';
import { client } from '../running';
import {
  areModesStale,
  isFileDrawn,
  isHistoryStale,
  keptFaces,
  results,
  shownMesh,
  view,
  wantedFaces,
  wants,
  whyKey,
} from '../store';
import { isTuningWanted, twin } from '../twin';
import { afterBody, afterHistory, keyed, keyedByFile, of, ofFaces } from './task';
import type { LevelStage, Task } from './task';

const REST_MILLISECONDS = 180;
const settings = () => wants.settings.value;
const body = () => wants.body.value;

/** The wanted faces when the slider last rested. */
const restedFaces = signal(0);

/** Whether results are displayed. */
const isReducing = (): boolean =>
  view.step.value === 'reduce' || view.step.value === 'test' || wants.exportOpen.value;

const areSeveral = (): boolean => (results.file.value?.bodies.length ?? 0) > 1;
const sharesNow = (): string => sharesKey(settings(), keptFaces.value);

/** Whether the slider moves: the processor is then left to the replay of the history. */
const isSliding = (): boolean => restedFaces.value !== wantedFaces.value;

/** The key of a stage that waits until the slider rests on a mesh that is shown; see replay.ts. */
const atRest = (stage: LevelStage) => (): string | null =>
  isReducing() && !isSliding() && isReplayed.value
    ? afterHistory(ofFaces(stage, () => restedFaces.value))()
    : null;

/** Whether the first result is being computed; everything else waits. */
const isResultAwaited = (): boolean => isReducing() && results.metrics.value === null;

/** Whether the file would look like its only body drawn without materials. */
function isBare(): boolean {
  const { bodies, contents } = results.file.value!;
  const { vertexColours, materials, animations } = contents;
  return bodies.length === 1 && !vertexColours && materials + animations === 0;
}

/** In the order in which they run, except for late ones. */
export const tasks: Task[] = [
  {
    what: 'Reading the mesh',
    key: keyed(of(STAGES.prepared)),
    run: () => client.call((worker) => worker.prepare(body(), settings())),
    result: results.body,
  },
  {
    what: 'Reading the materials',
    key: () =>
      results.body.value && canDrawFile() && !(isBare() && isResultAwaited())
        ? keyedByFile(() => 'original')()
        : null,
    run: () => client.call((worker) => worker.original()),
    result: results.originalFile,
    isOfFile: true,
    isLate: isBare,
  },
  {
    what: 'Finding pins',
    key: afterBody(of(STAGES.pinned)),
    run: () => findPins(client, body()),
    result: results.pins,
  },
  {
    what: 'Finding modes',
    key: afterBody(of(STAGES.modes)),
    run: () => client.call((worker) => worker.modes(body(), settings())),
    result: results.modes,
  },
  {
    what: 'Comparing the modes',
    key: () =>
      results.modes.value && !areModesStale.value && !isResultAwaited() && !isSliding()
        ? afterBody(of(STAGES.modes))()
        : null,
    run: () => client.call((worker) => worker.overview(body(), settings())),
    result: results.overview,
    isLate: () => view.step.value !== 'motion',
  },
  {
    what: 'Measuring strain',
    key: () => (results.modes.value && !areModesStale.value ? afterBody(of(STAGES.guidance))() : null),
    run: () => client.call((worker) => worker.guidance(body(), settings())),
    result: results.guidance,
  },
  {
    what: 'Measuring curvature',
    key: afterBody(of(STAGES.curvature)),
    run: () => client.call((worker) => worker.curvature(body(), settings())),
    result: results.curvature,
  },
  {
    what: 'Collapsing edges',
    key: afterBody(of(STAGES.history)),
    run: () => client.call((worker) => worker.history(body(), settings())),
    result: results.history,
  },
  {
    what: 'Distributing the faces',
    key: () => (isReducing() && areSeveral() ? afterHistory(sharesNow)() : null),
    run: () => client.call((worker) => worker.shares(settings(), keptFaces.value)),
    result: results.shares,
  },
  {
    what: 'Fitting the result',
    key: atRest(STAGES.fitted),
    run: () => client.call((worker) => worker.fit(body(), settings(), restedFaces.value)),
    result: results.fitted,
  },
  {
    what: 'Tuning the result for its solver',
    key: () => (isTuningWanted.value && results.fitted.value ? atRest(STAGES.tuned)() : null),
    run: () => client.call((worker) => worker.tune(body(), settings(), restedFaces.value)),
    result: results.tuned,
  },
  {
    what: 'Measuring the result',
    key: () => (results.fitted.value ? atRest(STAGES.measured)() : null),
    run: () => client.call((worker) => worker.measure(body(), settings(), restedFaces.value)),
    result: results.metrics,
  },
  {
    what: 'Writing and checking the file',
    key: () => (wants.exportOpen.value && !isSliding() ? afterHistory(exportedKey)() : null),
    run: () =>
      client.call((worker) => worker.export(exportSettings(settings()), keptFaces.value, exportRequest())),
    result: results.exported,
  },
  {
    what: 'Tuning for all generic solvers',
    key: () => (twin.wantsGeneric.value && !isSliding() ? afterHistory(genericKey)() : null),
    run: () =>
      client.call((worker) =>
        worker.genericFiles(exportSettings(settings()), keptFaces.value, exportRequest()),
      ),
    result: results.genericFiles,
    isPatient: true,
    giveUp: () => (twin.wantsGeneric.value = false),
  },
  {
    what: 'Drawing the levels',
    key: () =>
      wants.exportOpen.value && wants.levelsShown.value && settings().lods.length > 0
        ? afterHistory(levelsKey)()
        : null,
    run: () => client.call((worker) => worker.drawnLevels(settings(), keptFaces.value)),
    result: results.drawnLevels,
    isPatient: true,
  },
  {
    what: 'Applying materials to the result',
    key: () => (isResultFileWanted() ? keyedByFile(resultFileNow)() : null),
    run: () => client.call((worker) => worker.resultFile(settings(), keptFaces.value)),
    result: results.resultFile,
    isOfFile: true,
    isPatient: true,
  },
  {
    what: 'Comparing methods',
    key: comparisonTaskKey,
    run: () => compareMethods(client),
    result: comparison.compared,
    isPatient: true,
  },
  {
    what: 'Finding why vertices stay',
    key: () =>
      view.step.value === 'reduce' && view.hover.value !== null && results.metrics.value !== null
        ? afterHistory(whyKey)()
        : null,
    run: () => client.call((worker) => worker.why(body(), settings(), faceCount(shownMesh.value!.mesh))),
    result: results.why,
    isPatient: true,
  },
  {
    what: 'Marking the deviation',
    key: () => (isMarkingWanted() ? afterHistory(of(STAGES.deviationMarks))() : null),
    run: () => client.call((worker) => worker.marks(body(), settings())),
    result: results.marks,
    isPatient: true,
  },
];

const isResultFileWanted = (): boolean =>
  view.step.value === 'reduce' &&
  isFileDrawn.value &&
  !isHistoryStale.value &&
  results.metrics.value !== null &&
  !isSliding() &&
  canDrawFile() &&
  isStoppable();

/** Without shared memory a patient task can only be stopped by a fresh worker, which has everything to do again. */
const MAX_FACES_UNSTOPPABLE = 20_000;

const isMarkingWanted = (): boolean =>
  view.step.value === 'reduce' && results.metrics.value !== null && !isSliding() && isStoppable();

const isStoppable = (): boolean =>
  client.canStop || (results.history.value?.faces ?? 0) <= MAX_FACES_UNSTOPPABLE;

/** From now on, follows the slider: its faces are requested once it rests. */
export function startResting(): void {
  effect(() => {
    const faces = wantedFaces.value;
    const timer = setTimeout(() => (restedFaces.value = faces), REST_MILLISECONDS);
    return () => clearTimeout(timer);
  });
}
