/** Divides the faces that are requested of a file among its bodies. */

import type { Refused } from '../../core/core';
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

/** The request for a file. */
export interface RequestedFile extends FaceTarget {
  settings: Settings;
  /** whether strain and curvature are written as attributes */
  fields: boolean;
  /** whether a binding file is written, which refers to vertices of the result by index */
  binding?: boolean;
  /** targets of bodies with a number of faces of their own, by their indices in the file; the overall target is that of the others */
  own?: ReadonlyMap<number, number>;
  /** whether no other request follows: then histories may end where this one does */
  isOnly?: boolean;
}

/**
 * The request for all bodies of a file: by one queue of errors over the scene, or with `perBody`, and where they are levels of detail
 * of each other, the same share of each. Needs the history of every body. The page, the command line and the library all use
 * this function.
 */
export function requestFile(file: FileRun, asked: RequestedFile): FileRequest {
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

/** The fewest faces that the only request of a file needs of its only body; undefined for several bodies, whose targets follow from their histories. */
function fewestOfOnly(file: FileRun, { settings, isOnly, ...target }: RequestedFile): number | undefined {
  if (!isOnly || file.usable.length !== 1) return undefined;
  const [{ layers }] = file.prepared(settings);
  const levels = [target, ...settings.lods.map((ratio): FaceTarget => ({ faces: null, ratio }))];
  const written = Math.min(...levels.map((level) => wantedFaces(level, allFaces(layers))));
  // A level has at most `layers.most` written faces for each of its own.
  return Math.max(1, Math.floor(written / layers.most));
}

type Usable = FileRun['usable'];
/** Maps a target to the most faces of each body that shares it. */
type Share = (asked: FaceTarget) => number[];

type CurveSettings = Settings & Pick<RunSettings, 'fewestFaces'>;

/** The share of histories in the work of a request; the rest is fits and measures. */
const HISTORIES_IN_REQUEST = 0.6;

/** `share`: of what is left of the call, see FileProgress. */
function curvesOf(file: FileRun, shared: Usable, settings: CurveSettings, share: number): ErrorCurve[] {
  // Curves follow from histories, which do not depend on the requested faces.
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

/** The larger of the two targets, which is reached first; 1 without a target. */
const wantedFaces = ({ faces, ratio }: FaceTarget, all: number): number =>
  Math.max(1, ratio === null ? 0 : facesByRatio(ratio, all), faces ?? 0);

/** The targets of the bodies. If the scene cannot have so few faces, they are lowered in proportion, so that they count as missed. */
function targetsInQueue(queue: SceneQueue, wanted: number): number[] {
  const targets = queue.targets(wanted);
  const share = Math.min(1, wanted / queue.fewest);
  return targets.map((own) => Math.max(1, Math.floor(share * own)));
}

/** The queue of these bodies, from the error curves of their histories. */
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
  /** the number that is shared: the requested one, by default half of the faces */
  wanted: number;
  /** the number of faces of the originals, and the fewest that they can have */
  faces: number;
  fewest: number;
  /** why not fewer, of these bodies together */
  refused: Refused;
  /** targets[i]: of body i of the file */
  targets: number[];
  /** faces of each body as the result will have them without limits: like `targets`, but a body stops at the fewest faces it can have */
  expected: number[];
}

/** The targets that `requestFile` gives each body, and the range of the shared number. */
export function shareFaces(file: FileRun, asked: RequestedFile): SharedFaces {
  const { settings, own } = asked;
  const shared = file.usable.filter(({ i }) => !own?.has(i));
  const queue = sceneQueue(file, shared, settings, 1);
  const { faces, fewest, refused } = queue;
  const wanted = wantedFaces(asked, faces);
  const { targets } = requestFile(file, asked);
  const isReached = wanted >= fewest;
  const expected = isReached ? targets : requestFile(file, { ...asked, faces: fewest }).targets;
  return { wanted, faces, fewest, refused, targets, expected };
}
