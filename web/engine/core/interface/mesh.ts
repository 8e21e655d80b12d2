/** Meshes: welding, inspection, quality, curvature and mirror symmetry. */

/** An indexed triangle mesh with corners counter-clockwise seen from outside. */
export interface TriangleMesh {
  /** positions[3 * v + c], in units of the file */
  positions: Float32Array;
  /** triangles[3 * t + corner], vertex indices */
  triangles: Uint32Array;
}

/** Stands for a vertex, triangle or corner that does not exist. */
export const NONE = 0xffffffff;

export interface WeldOptions {
  /** vertices closer than this become one, in % of the bounding box's diagonal; 0: bitwise equal positions only */
  tolerance: number;
}

/** A welded body, ready for all other functions, and the origin of its vertices and triangles. */
export interface WeldResult {
  mesh: TriangleMesh;
  /** per source vertex: its vertex in `mesh`, or NONE if no usable face has it */
  vertexOfSource: Uint32Array;
  /** per triangle of `mesh`: its index in the source */
  sourceOfTriangle: Uint32Array;
  weldedVertices: number;
  degenerateFaces: number;
  duplicateFaces: number;
  flippedFaces: number;
  /** inspection of the welded source without degenerate faces but with duplicates */
  inspection: Inspection;
}

/** Counts, topology and defects of a mesh. */
export interface Inspection {
  vertices: number;
  faces: number;
  components: number;
  /** closed components with a volume: they move as solids by themselves, the others as shells */
  solidComponents: number;
  boundaryLoops: number;
  /** summed over components; null if the mesh is non-manifold or not orientable */
  genus: number | null;
  eulerCharacteristic: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  orientationClashes: number;
}

export interface Quality {
  /** degrees */
  minAngle: number;
  meanMinAngle: number;
}

export interface Curvature {
  /** |mean curvature| per vertex, 1 / unit */
  vertex: Float32Array;
  /** per triangle, the mean of its vertices */
  triangle: Float32Array;
}

/** Divides a mesh into charts, across whose borders no attribute may bleed. Both arrays may be empty. */
export interface Charts {
  /** wedges[3 * t + corner]: equal for corners at a vertex that have equal attributes */
  wedges: Uint32Array;
  /** per triangle: its primitive or material */
  groups: Uint32Array;
}

/** The mirror symmetry of a mesh, or how far it is from one; see wasm/simplify/symmetry/mirror_images.h. */
export interface MirrorImages {
  /** SimplifyConstraints.mirror; empty if there is no symmetry */
  partners: Uint32Array;
  /**
   * Per corner of the mesh with some quads cut along the other diagonal: the corner of the input mesh that it was; empty if
   * the mesh is symmetric without such cuts, or not symmetric at all.
   */
  corners: Uint32Array;
  /** vertices without an image */
  asymmetricVertices: number;
  /** triangles of the input mesh without an image although their vertices have images */
  asymmetricTriangles: number;
}

/** A point of a surface. */
export interface SurfacePoint {
  triangle: number;
  barycentric: [number, number, number];
}

/** A mesh that the core keeps, so that later calls need not copy it; see `keepMesh`. */
export interface MeshHandle {
  readonly handle: number;
}

/** A mesh as plain data, or one that the core keeps. */
export type MeshInput = TriangleMesh | MeshHandle;

/** The functions of the core on this topic. */
export interface MeshFunctions {
  weld(positions: Float32Array, indices: Uint32Array, options: WeldOptions): WeldResult;
  inspect(mesh: MeshInput): Inspection;
  meanCurvature(mesh: MeshInput): Curvature;
  /** looks for mirror symmetry across the plane through the centre normal to axis 0, 1 or 2; -1: tries all */
  findMirrorImages(mesh: MeshInput, charts: Charts, axis: number): MirrorImages;
  measureQuality(mesh: MeshInput): Quality;
  /** copies a mesh into the core, which keeps it until `releaseMesh` */
  keepMesh(mesh: TriangleMesh): MeshHandle;
  releaseMesh(handle: MeshHandle): null;
}
