/** Finds vertices of a mesh at rest under a ray and around a point. */

import { faceCount } from '../../engine/core/mesh';
import { BufferAttribute, BufferGeometry, DoubleSide, Sphere, Vector3 } from 'three';
import type { Ray } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { SerializedBVH } from 'three-mesh-bvh';
import type { TriangleMesh } from '../../engine/core/core';

export interface PickedVertex {
  vertex: number;
  /** the point where the ray hits the surface */
  point: Vector3;
  /** of the hit triangle */
  normal: Vector3;
}

/** A tree of more triangles than this is built in a worker, as it would block the page. */
const MAX_TRIANGLES_AT_ONCE = 30_000;

export class Picker {
  private constructor(
    private readonly mesh: TriangleMesh,
    private readonly tree: MeshBVH,
  ) {}

  /** Returns at once for small meshes, later for large ones; rejects if the worker cannot be loaded or fails. */
  static of(mesh: TriangleMesh): Picker | Promise<Picker> {
    const geometry = geometryOf(mesh);
    if (faceCount(mesh) <= MAX_TRIANGLES_AT_ONCE) return new Picker(mesh, buildTree(geometry));
    return buildInWorker(mesh).then(
      (built) => new Picker(mesh, MeshBVH.deserialize(built, geometry, { setIndex: false })),
    );
  }

  /** The corner nearest to the first hit of the ray, from either side; null if the ray misses. */
  underRay(ray: Ray): PickedVertex | null {
    const hit = this.tree.raycastFirst(ray, DoubleSide);
    if (!hit || typeof hit.faceIndex !== 'number') return null;
    const corners = [0, 1, 2].map((corner) => this.mesh.triangles[3 * hit.faceIndex! + corner]);
    const distances = corners.map((vertex) => this.squaredDistance(vertex, hit.point));
    const vertex = corners[distances.indexOf(Math.min(...distances))];
    return { vertex, point: hit.point, normal: hit.face!.normal };
  }

  /** Every vertex at most `radius` from the point, with its distance. */
  around(point: Vector3, radius: number): Map<number, number> {
    const sphere = new Sphere(point, radius);
    const found = new Map<number, number>();
    this.tree.shapecast({
      intersectsBounds: (box) => sphere.intersectsBox(box),
      intersectsTriangle: (_triangle, face) => {
        for (let corner = 0; corner < 3; corner++) {
          const vertex = this.mesh.triangles[3 * face + corner];
          const distance = Math.sqrt(this.squaredDistance(vertex, point));
          if (distance <= radius) found.set(vertex, distance);
        }
        return false;
      },
    });
    return found;
  }

  private squaredDistance(vertex: number, { x, y, z }: Vector3): number {
    const { positions } = this.mesh;
    const [dx, dy, dz] = [
      positions[3 * vertex] - x,
      positions[3 * vertex + 1] - y,
      positions[3 * vertex + 2] - z,
    ];
    return dx * dx + dy * dy + dz * dz;
  }
}

export function geometryOf({ positions, triangles }: TriangleMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return geometry;
}

/** The tree is indirect, so that the triangles of the mesh keep their order. */
export const buildTree = (geometry: BufferGeometry): MeshBVH => new MeshBVH(geometry, { indirect: true });

function buildInWorker(mesh: TriangleMesh): Promise<SerializedBVH> {
  const worker = new Worker(new URL('./tree_worker.ts', import.meta.url), { type: 'module' });
  return new Promise<SerializedBVH>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<SerializedBVH>) => resolve(data);
    // A script that cannot be loaded causes an event without a message.
    worker.onerror = ({ message }) => reject(new Error(message ?? 'Failed to fetch its script'));
    worker.postMessage(mesh);
  }).finally(() => worker.terminate());
}
