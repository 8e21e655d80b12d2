/** The outline of the brush on the surface. */

import { BufferGeometry, LineBasicMaterial, LineLoop, Quaternion, Vector3 } from 'three';

/** The position where the brush touches the surface, in units of the mesh. */
export interface BrushMark {
  point: Vector3;
  normal: Vector3;
  radius: number;
  colour: string;
}

const CORNERS = 64;
const ALONG_Z = new Vector3(0, 0, 1);

export class BrushRing {
  readonly line: LineLoop<BufferGeometry, LineBasicMaterial>;

  constructor() {
    const circle = Array.from({ length: CORNERS }, (_, i) => {
      const angle = (2 * Math.PI * i) / CORNERS;
      return new Vector3(Math.cos(angle), Math.sin(angle), 0);
    });
    // The ring is drawn on top of everything: a curved surface would hide half of it.
    const material = new LineBasicMaterial({ depthTest: false, transparent: true });
    this.line = new LineLoop(new BufferGeometry().setFromPoints(circle), material);
    this.line.frustumCulled = false;
    this.line.renderOrder = 1;
    this.line.visible = false;
  }

  /** Shows the ring at a mark; null hides it. */
  show(mark: BrushMark | null): void {
    this.line.visible = mark !== null;
    if (!mark) return;
    this.line.position.copy(mark.point);
    this.line.quaternion.copy(new Quaternion().setFromUnitVectors(ALONG_Z, mark.normal.clone().normalize()));
    this.line.scale.setScalar(mark.radius);
    this.line.material.color.set(mark.colour);
  }
}
