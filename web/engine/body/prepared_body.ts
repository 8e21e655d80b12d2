/** A body as the stages work on it: welded, inspected, with the attributes of its corners. */

import type { Inspection, MirrorImages, Quality, TriangleMesh, WeldResult } from '../core/core';
import type { Body } from '../document/model';
import type { BodyAttributes } from './attributes';
import type { Layers } from './layers';

/** A welded body, usable or not. */
export interface InspectedBody {
  weld: WeldResult;
  /** of weld.mesh, the usable part */
  inspection: Inspection;
  /** null where no face is usable */
  quality: Quality | null;
}

/** A body that every stage can work on: at least one of its faces is usable. */
export interface PreparedBody extends InspectedBody {
  body: Body;
  /** the usable part, welded: all stages compute on it */
  mesh: TriangleMesh;
  /** of the bounding box of `mesh`, in its units */
  diagonal: number;
  /** of `mesh`; weld.inspection is of the body as it came */
  inspection: Inspection;
  quality: Quality;
  /** what its corners carry besides positions */
  attributes: BodyAttributes;
  /** the faces of the body on each triangle of `mesh` */
  layers: Layers;
  /** number of surface points, besides the vertices, at which distances are measured; 0: the core's default for a single body */
  samples: number;
  /** present where a symmetry is asked for; `partners` are those of `mesh`, whose quads are already cut as `corners` ask */
  images?: MirrorImages;
}

/** The size of a body, for materials. */
export interface BodySize {
  /** `scale`: units of the file per unit of the mesh */
  body: { scale: number };
  /** of the bounding box, in units of the mesh */
  diagonal: number;
}
