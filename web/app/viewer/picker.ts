/** Finds vertices of a mesh at rest under a ray and around a point. */

import { BufferAttribute, BufferGeometry, DoubleSide, Sphere, Vector3 } from 'three';
import type { Ray } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import type { TriangleMesh } from '../../engine/core';

export interface PickedVertex {
  vertex: number;
  /** where the ray meets the surface */
  point: Vector3;
}

export class Picker {
  private readonly tree: MeshBVH;

  constructor(private readonly mesh: TriangleMesh) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
    geometry.setIndex(new BufferAttribute(mesh.triangles, 1));
    // Indirect: the mesh's own triangles stay in their order.
    this.tree = new MeshBVH(geometry, { indirect: true });
  }

  /** The corner nearest to where the ray first meets the surface, from either side; null where it misses. */
  underRay(ray: Ray): PickedVertex | null {
    const hit = this.tree.raycastFirst(ray, DoubleSide);
    if (!hit || typeof hit.faceIndex !== 'number') return null;
    const corners = [0, 1, 2].map((corner) => this.mesh.triangles[3 * hit.faceIndex! + corner]);
    const distances = corners.map((vertex) => this.place(vertex).distanceToSquared(hit.point));
    return { vertex: corners[distances.indexOf(Math.min(...distances))], point: hit.point };
  }

  /** Every vertex at most `radius` from the point. */
  around(point: Vector3, radius: number): number[] {
    const sphere = new Sphere(point, radius);
    const found = new Set<number>();
    this.tree.shapecast({
      intersectsBounds: (box) => sphere.intersectsBox(box),
      intersectsTriangle: (_triangle, face) => {
        for (let corner = 0; corner < 3; corner++) {
          const vertex = this.mesh.triangles[3 * face + corner];
          if (sphere.containsPoint(this.place(vertex))) found.add(vertex);
        }
        return false;
      },
    });
    return [...found];
  }

  private place(vertex: number): Vector3 {
    return new Vector3().fromArray(this.mesh.positions, 3 * vertex);
  }
}
