/** Meshes: welding, inspection, quality, curvature and mirror symmetry. */

/** An indexed triangle surface; corners counter-clockwise seen from outside. Every coordinate is a float32. */
export interface TriangleMesh {
  /** positions[3 * v + c], in units of the file */
  positions: Float32Array;
  /** triangles[3 * t + corner], vertex indices */
  triangles: Uint32Array;
}

export const NONE = 0xffffffff;

export interface WeldOptions {
  /** vertices closer than this become one, in % of the bounding box's diagonal; 0: bitwise equal positions only */
  tolerance: number;
}

/** A body ready for everything else, and where its parts came from. */
export interface WeldResult {
  mesh: TriangleMesh;
  /** per source vertex: its vertex in `mesh`, or NONE where no usable face needs it */
  vertexOfSource: Uint32Array;
  /** per triangle of `mesh`: its index in the source */
  sourceOfTriangle: Uint32Array;
  weldedVertices: number;
  degenerateFaces: number;
  duplicateFaces: number;
  flippedFaces: number;
  /** the source as it came: welded, degenerate faces dropped, duplicates still there */
  inspection: Inspection;
}

/** What a mesh is like, and what is wrong with it. */
export interface Inspection {
  vertices: number;
  faces: number;
  components: number;
  boundaryLoops: number;
  /** summed over components; null where the mesh is non-manifold or not orientable */
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

/** What parts a mesh into charts, over which no attribute may bleed. Both may be empty. */
export interface Charts {
  /** wedges[3 * t + corner]: equal at a vertex where all attributes are */
  wedges: Uint32Array;
  /** per triangle: what it is drawn with */
  groups: Uint32Array;
}

/** The mirror symmetry of a mesh, or how far it is from one; see wasm/simplify/symmetry/mirror_images.h. */
export interface MirrorImages {
  /** SimplifyConstraints.mirror; empty where there is no symmetry */
  partners: Uint32Array;
  /**
   * Per corner of the mesh with some quads cut the other way: which corner of the mesh it has been; empty where it is
   * symmetric as it stands, or not at all.
   */
  corners: Uint32Array;
  /** without an image */
  asymmetricVertices: number;
  /** without an image, as the mesh stands, though their vertices have theirs */
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
  /** the plane through the centre that a mesh is symmetric to: normal to axis 0, 1 or 2; -1: any that is found */
  findMirrorImages(mesh: MeshInput, charts: Charts, axis: number): MirrorImages;
  measureQuality(mesh: MeshInput): Quality;
  /** copies a mesh into the core, which keeps it until `releaseMesh` */
  keepMesh(mesh: TriangleMesh): MeshHandle;
  releaseMesh(handle: MeshHandle): null;
}
