/** How many faces each body of a file may keep, of what is asked of the file as a whole. */

import { allFaces } from '../../body/layers';
import { instanceScale } from '../../document/placements';
import type { Settings } from '../../settings/options';
import { errorCurveStage } from './error_curve';
import type { ErrorCurve } from './error_curve';
import { facesByRatio, targetsOf } from './face_shares';
import type { FaceTarget } from './face_shares';
import type { FileRequest } from '../file_request';
import type { FileRun } from '../file_run';
import type { RunSettings } from '../stage';
import { runBodies } from '../many_bodies/parallel_bodies';
import { SceneQueue } from './scene_budget';

/** What is asked of a file. */
export interface FileAsked extends FaceTarget {
  settings: Settings;
  /** whether strain and curvature are written as attributes */
  fields: boolean;
  /** whether a binding file is written, which counts vertices of the result */
  binding?: boolean;
  /** faces of bodies that have a number of their own, by their numbers in the file; the target of the whole is that of the others */
  own?: ReadonlyMap<number, number>;
  /** whether no other request follows: then histories may end where this one needs no more of them */
  isOnly?: boolean;
}

/**
 * The request for all bodies of a file: by one queue of errors over the scene, or with `perBody`, and where they are levels of detail
 * of each other, the same share of each. Needs the history of every body. The page, the command line and the library all ask for files
 * through this.
 */
export function requestFile(file: FileRun, asked: FileAsked): FileRequest {
  const { settings, fields, binding, own, ...target } = asked;
  const shared = file.usable.filter(({ i }) => !own?.has(i));
  const fewestFaces = fewestOfOnly(file, asked);
  const share =
    settings.perBody || file.model.hasLevels
      ? shareEach(file, shared, settings)
      : shareScene(file, shared, { ...settings, fewestFaces });
  const targetsFor = (asked: FaceTarget): number[] => {
    const targets = file.model.bodies.map((_, i) => own?.get(i) ?? 0);
    share(asked).forEach((faces, n) => (targets[shared[n].i] = faces));
    return targets;
  };
  return {
    settings,
    fields,
    binding,
    faces: target.faces ?? undefined,
    targets: targetsFor(target),
    levelTargets: settings.lods.map((ratio) => targetsFor({ faces: null, ratio })),
    fewestFaces,
  };
}

/** The fewest faces that the only request of a file asks of the only body that takes part; of more bodies they follow from their histories. */
function fewestOfOnly(file: FileRun, { settings, isOnly, ...target }: FileAsked): number | undefined {
  if (!isOnly || file.usable.length !== 1) return undefined;
  const [{ layers }] = file.prepared(settings);
  const levels = [target, ...settings.lods.map((ratio): FaceTarget => ({ faces: null, ratio }))];
  const written = Math.min(...levels.map((level) => wantedFaces(level, allFaces(layers))));
  // A level has at most `layers.most` written faces for each of its own.
  return Math.max(1, Math.floor(written / layers.most));
}

type Usable = FileRun['usable'];
/** Per shared body the most faces that it may have. */
type Share = (asked: FaceTarget) => number[];

type CurveSettings = Settings & Pick<RunSettings, 'fewestFaces'>;

/** The rest is what a request is for: fits and measures. */
const HISTORIES_IN_REQUEST = 0.6;

/** `share`: of what is left of the call, see FileProgress. */
function curvesOf(file: FileRun, shared: Usable, settings: CurveSettings, share: number): ErrorCurve[] {
  // Curves follow from histories, which know nothing of the faces that are asked for.
  const ofRun: RunSettings = Object.freeze({ ...settings, targetFaces: 1, fields: false });
  runBodies(file, shared, { settingsOf: () => ofRun, last: errorCurveStage, share });
  return shared.map(({ run }) => run.get(errorCurveStage, ofRun));
}

function shareEach(file: FileRun, shared: Usable, settings: Settings): Share {
  const counts = file.preparedOf(shared, settings).map(({ mesh }) => mesh.triangles.length / 3);
  return (asked) => targetsOf(counts, asked);
}

function shareScene(file: FileRun, shared: Usable, settings: CurveSettings): Share {
  if (shared.length === 0) return () => [];
  const queue = sceneQueue(file, shared, settings, HISTORIES_IN_REQUEST);
  return (asked) => targetsInQueue(queue, wantedFaces(asked, queue.faces));
}

/** Of a ratio and a number of faces the one that is reached first; 1 where neither is asked for. */
const wantedFaces = ({ faces, ratio }: FaceTarget, all: number): number =>
  Math.max(1, ratio === null ? 0 : facesByRatio(ratio, all), faces ?? 0);

/** Below the fewest faces of the scene the targets are below those of the bodies, in proportion, so that they count as missed. */
function targetsInQueue(queue: SceneQueue, wanted: number): number[] {
  const targets = queue.targets(wanted);
  const share = Math.min(1, wanted / queue.fewest);
  return targets.map((own) => Math.max(1, Math.floor(share * own)));
}

/** The queue of these bodies; its curves follow from their histories. */
function sceneQueue(file: FileRun, shared: Usable, settings: CurveSettings, share: number): SceneQueue {
  const { document } = file.model;
  const meshes = document.getRoot().listMeshes();
  const curves = curvesOf(file, shared, settings, share);
  return new SceneQueue(
    shared.map(({ run }, n) => ({
      curve: curves[n],
      scale: instanceScale(document, meshes[run.context.body.mesh]),
      limit: settings.maxDeviation,
    })),
  );
}

/** The faces of the bodies of a file that share a number of faces. */
export interface SharedFaces {
  /** the number that is shared: as asked for, half where nothing is */
  wanted: number;
  /** as the bodies came, and the fewest that they can have */
  faces: number;
  fewest: number;
  /** targets[i]: of body i of the file */
  targets: number[];
}

/** What `requestFile` asks of each body, and the range of the number that is shared. */
export function shareFaces(file: FileRun, asked: FileAsked): SharedFaces {
  const { settings, own } = asked;
  const shared = file.usable.filter(({ i }) => !own?.has(i));
  const queue = sceneQueue(file, shared, settings, 1);
  const { faces, fewest } = queue;
  return { wanted: wantedFaces(asked, faces), faces, fewest, targets: requestFile(file, asked).targets };
}
