/** What the stages report about the result of one body. */

import type { Fitted, Inspection, Quality, SurfaceDistance, WeldResult } from '../core/core';
import type { Settings } from '../settings/options';

/** An optimized mesh beside its original. */
export interface Measured {
  /** of the mesh as a reader of the exported file welds it */
  weld: WeldResult;
  inspection: Inspection;
  quality: Quality;
  /** in % of the original's diagonal */
  distance: SurfaceDistance;
  certificate: Certificate;
}

/** Whether the result has the topology of the original. */
export interface Certificate {
  components: boolean;
  boundaryLoops: boolean;
  genus: boolean;
  /** all of them */
  kept: boolean;
}

export interface FittedResult extends Fitted {
  /** how it was fitted, or was to be fitted; `off` also where a fit to the surface changes nothing; only a modal fit knows frequency errors */
  kind: Settings['fit'];
  /** why the result, or parts of it, stay as the collapses left them; '' where all parts are fitted or none is to be */
  unfitted: string;
}

/** The deviation limit that stopped a body; % of the diagonal. */
export interface GuardFinding {
  /** the largest deviation of the settings */
  limit: number;
  /** of the result */
  deviation: number;
}

/** A number of faces that was tried in the search for a largest frequency error. */
export interface Tried {
  faces: number;
  /** the largest frequency error there, in % */
  error: number;
}

/** What the search for a largest frequency error has found. */
export interface FrequencyFinding {
  /** the largest error that was asked for, in % */
  limit: number;
  /** the largest error of the first six modes at the faces that were found, in % */
  error: number;
  /** whether every other target would have allowed fewer faces */
  isBinding: boolean;
  /** in the order of the search */
  tried: Tried[];
}
