/** Painted levels on a body: onto its welded mesh and back, and what they mean there; see settings/paint_text.ts. */

import { vertexCount } from '../core/mesh';
import { NONE } from '../core/core';
import { SettingError } from '../settings/errors';
import { LOCKED, parsePaint, STRONGEST } from '../settings/paint_text';
import type { Levels } from '../settings/paint_text';
import type { PreparedBody } from './prepared_body';

/** Per vertex of the welded mesh the highest level of its sources; null where the mesh is bare. Throws SettingError. */
export function paintOn(
  text: string,
  { body, weld, mesh }: Pick<PreparedBody, 'weld' | 'mesh'> & { body: { name: string; mesh: number } },
): Levels | null {
  const levels = parsePaint(text).get(body.mesh);
  if (!levels) return null;
  const { vertexOfSource } = weld;
  if (levels.length !== vertexOfSource.length)
    throw new SettingError(
      'paint',
      `is for ${levels.length} vertices, but "${body.name}" has ${vertexOfSource.length}: open the file that was painted.`,
    );
  return weldLevels(levels, vertexOfSource, vertexCount(mesh));
}

/** From source vertices to the welded mesh, where the highest level counts; `vertexOfSource` as WeldResult has it. */
export function weldLevels(levels: Levels, vertexOfSource: Uint32Array, vertexCount: number): Levels {
  const welded = new Uint8Array(vertexCount);
  levels.forEach((level, source) => {
    const vertex = vertexOfSource[source];
    if (vertex !== NONE) welded[vertex] = Math.max(welded[vertex], level);
  });
  return welded;
}

/** Back from the welded mesh to its sources. */
export function unweldLevels(welded: Levels, vertexOfSource: Uint32Array): Levels {
  return Uint8Array.from(vertexOfSource, (vertex) => (vertex === NONE ? 0 : welded[vertex]));
}

/** The keep weights that the levels stand for, in [0, 1]; 1 at a locked vertex. */
export const keepOfLevels = (levels: Levels): Float32Array =>
  Float32Array.from(levels, (level) => Math.min(level, STRONGEST) / STRONGEST);

/** The locked vertices, ascending. */
export function lockedIn(levels: Levels): number[] {
  const locked: number[] = [];
  levels.forEach((level, vertex) => {
    if (level === LOCKED) locked.push(vertex);
  });
  return locked;
}

/** The level of a vertex after a stroke; `nearness` in [0, 1] is 1 in the middle of the brush. */
export function painted(level: number, tool: 'keep' | 'lock' | 'erase', nearness: number): number {
  if (tool === 'erase') return 0;
  if (tool === 'lock') return LOCKED;
  return level === LOCKED ? level : Math.max(level, Math.ceil(STRONGEST * nearness));
}
