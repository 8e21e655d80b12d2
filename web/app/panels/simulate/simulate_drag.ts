/** Lets the pointer drag the moving bodies. */

import type { Ray, Vector3 } from 'three';
import type { TriangleMesh } from '../../../engine/core/core';
import { dragTo, grab, releaseDrag } from '../../state/simulation';
import { twin } from '../../state/twin';
import { results, shownMesh } from '../../state/store';
import type { PaneName } from '../../viewer/pane_layout';
import { DragTool, hitAt } from '../../viewer/twin_drag';
import type { SurfaceHit } from '../../viewer/twin_drag';
import type { Viewport } from '../../viewer/viewport';
import { isDriven, isOverlaid, isSimulating } from './simulate_view';

export function connectDragging(canvas: HTMLCanvasElement, viewport: Viewport): DragTool<PaneName> {
  return new DragTool<PaneName>(canvas, {
    rayAt: (x, y, fromX) => (isSimulating() ? viewport.rayAt(x, y, fromX) : null),
    hitAt: (ray, x) => bodyUnder(ray, isOverlaid.value ? ['original', 'optimized'] : [viewport.paneAt(x)]),
    grab,
    drag: dragTo,
    release: releaseDrag,
  });
}

interface ShownBody {
  name: PaneName;
  mesh: TriangleMesh;
  positions: Float32Array;
}

/** The body that a pane shows: the right side may show the original driven by the optimized body. */
function bodyIn(pane: PaneName): ShownBody | null {
  const frame = twin.frame.value;
  const [body, result] = [results.body.value, shownMesh.value];
  if (!frame || !twin.numbers.value || !body || !result) return null;
  const { original, optimized } = frame.bodies;
  if (pane === 'original') return { name: 'original', mesh: body.mesh, positions: original.positions };
  if (!isDriven.value) return { name: 'optimized', mesh: result.mesh, positions: optimized.positions };
  return frame.driven && { name: 'original', mesh: body.mesh, positions: frame.driven };
}

/** The body of these panes that the ray hits first. */
function bodyUnder(ray: Ray, panes: PaneName[]): { name: PaneName; hit: SurfaceHit } | null {
  const hits = panes.flatMap((pane) => {
    const body = bodyIn(pane);
    const hit = body && hitAt(ray, body.mesh, body.positions);
    return hit ? [{ name: body.name, hit }] : [];
  });
  const distance = ({ hit }: { hit: SurfaceHit }) => hit.position.distanceTo(ray.origin as Vector3);
  return hits.sort((a, b) => distance(a) - distance(b))[0] ?? null;
}
