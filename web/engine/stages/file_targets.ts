/** How many faces each body of a file may keep, of what is asked of the file as a whole. */

import { sum } from '../core/mesh';
import { placedScale } from '../document/placements';
import type { Settings } from '../settings/options';
import { errorCurveStage } from './error_curve';
import type { ErrorCurve } from './error_curve';
import { facesByRatio, targetsOf } from './face_shares';
import type { FaceTarget } from './face_shares';
import type { FileRequest } from './file_request';
import type { FileRun } from './file_run';
import { SceneQueue } from './scene_budget';

/** What is asked of a file. */
export interface FileAsked extends FaceTarget {
  settings: Settings;
  /** whether strain and curvature are written as attributes */
  fields: boolean;
  /** faces of bodies that have a number of their own, by their numbers in the file; the target of the whole is that of the others */
  own?: ReadonlyMap<number, number>;
}

/**
 * The request for all bodies of a file: by one queue of errors over the scene, or with `perBody` the same share of each. Needs the
 * history of every body. The page, the command line and the library all ask for files through this.
 */
export function requestFile(file: FileRun, { settings, fields, own, ...target }: FileAsked): FileRequest {
  const shared = file.usable.filter(({ i }) => !own?.has(i));
  const share = settings.perBody ? shareEach(file, shared, settings) : shareScene(file, shared, settings);
  const targetsFor = (asked: FaceTarget): number[] => {
    const targets = file.model.bodies.map((_, i) => own?.get(i) ?? 0);
    share(asked).forEach((faces, n) => (targets[shared[n].i] = faces));
    return targets;
  };
  return {
    settings,
    fields,
    targets: targetsFor(target),
    levelTargets: settings.lods.map((ratio) => targetsFor({ faces: null, ratio })),
  };
}

type Usable = FileRun['usable'];
/** Per shared body the most faces that it may have. */
type Share = (asked: FaceTarget) => number[];

function curvesOf(file: FileRun, shared: Usable, settings: Settings): ErrorCurve[] {
  return shared.map(({ run }) => {
    file.announce(run);
    return run.get(errorCurveStage, settings);
  });
}

function shareEach(file: FileRun, shared: Usable, settings: Settings): Share {
  const counts = file.preparedOf(shared, settings).map(({ mesh }) => mesh.triangles.length / 3);
  return (asked) => targetsOf(counts, asked);
}

function shareScene(file: FileRun, shared: Usable, settings: Settings): Share {
  const queue = sceneQueue(file, shared, settings);
  return ({ faces, ratio }) => {
    if (shared.length === 0) return [];
    const ofRatio = ratio === null ? 0 : facesByRatio(ratio, queue.faces);
    return queue.targets(Math.max(1, ofRatio, faces ?? 0)).map((own) => Math.max(1, own));
  };
}

/** The queue of these bodies; its curves follow from their histories. */
export function sceneQueue(file: FileRun, shared: Usable, settings: Settings): SceneQueue {
  const { document } = file.model;
  const meshes = document.getRoot().listMeshes();
  const curves = curvesOf(file, shared, settings);
  return new SceneQueue(
    shared.map(({ run }, n) => ({
      curve: curves[n],
      scale: placedScale(document, meshes[run.context.body.mesh]),
      limit: settings.maxDeviation,
    })),
  );
}

/** The faces of a whole file that a request asks for at most. */
export const askedFaces = ({ targets }: FileRequest): number => sum(targets);
