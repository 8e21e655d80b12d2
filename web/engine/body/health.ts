/** The state of a body in plain words, for the health list of the page and the notes of the command line. */

import type { Inspection, ModeSet, WeldResult } from '../core/core';
import { counted } from '../core/words';
import type { Note } from '../settings/errors';
import type { Body } from '../document/model';

export interface HealthNote {
  /** `fact`: good to know; `repaired`: something was corrected or set aside; `limit`: something cannot work fully */
  kind: 'fact' | 'repaired' | 'limit';
  text: string;
  /** what happens to it in a result, in words that follow `text`; absent where there is nothing to say */
  fate?: string;
}

/** See `withLayers`. */
const DUPLICATES_FATE = 'and put back on each face that is left';

/** `inspection`: of the usable part, so that an edge which only duplicate faces share is no limit. */
export function describeHealth(body: Body, weld: WeldResult, inspection: Inspection): HealthNote[] {
  const { weldedVertices, degenerateFaces, duplicateFaces, flippedFaces } = weld;
  const notes: HealthNote[] = body.notes.map((text) => ({ kind: 'repaired', text }));
  const add = (kind: HealthNote['kind'], count: number, text: string, fate?: string) => {
    if (count > 0) notes.push({ kind, text, ...(fate === undefined ? {} : { fate }) });
  };
  const seams = counted(weldedVertices, 'seam vertex', 'seam vertices');
  add('repaired', weldedVertices, `${seams} welded`);
  add('repaired', degenerateFaces, `${counted(degenerateFaces, 'face')} with a repeated vertex set aside`);
  add('repaired', duplicateFaces, `${counted(duplicateFaces, 'duplicate face')} set aside`, DUPLICATES_FATE);
  const neighbours = flippedFaces === 1 ? 'its neighbours' : 'their neighbours';
  add('repaired', flippedFaces, `${counted(flippedFaces, 'face')} turned to agree with ${neighbours}`);
  const { nonManifoldEdges, nonManifoldVertices, components, boundaryLoops, orientationClashes } = inspection;
  add(
    'limit',
    nonManifoldEdges,
    `${counted(nonManifoldEdges, 'edge')} shared by more than two faces, locked`,
  );
  add(
    'limit',
    nonManifoldVertices,
    `${counted(nonManifoldVertices, 'vertex', 'vertices')} where surfaces only touch, locked`,
  );
  const clashes = counted(orientationClashes, 'edge');
  if (flippedFaces === 0)
    add('limit', orientationClashes, `${clashes} between faces of opposite orientation`);
  if (components > 1) add('fact', components, counted(components, 'part'));
  add('fact', boundaryLoops, `${counted(boundaryLoops, 'open border')}`);
  return notes;
}

/** A clause that doubts the size of the body in metres where it is implausible; otherwise null. Frequencies depend on the size. */
export function describeSize(metres: number): Note | null {
  if (metres >= 0.001 && metres <= 1000) return null;
  const size = metres < 1 ? `${(1000 * metres).toPrecision(2)} mm` : `${(metres / 1000).toPrecision(2)} km`;
  return [`the body is ${size} across: set `, { setting: 'unit' }, ' if the file is not in metres'];
}

/** A sentence without its end where parts of a body could not be solved, so that no strain guides them; otherwise none. */
export function describeFailedModes(name: string, modes: ModeSet | null): string[] {
  const parts = modes?.components ?? [];
  const failed = parts.filter(({ failure = '' }) => failure !== '');
  if (failed.length === 0) return [];
  const which = parts.length > 1 ? `${counted(failed.length, 'part')} of ${parts.length} in ${name}` : name;
  const why = failed[0].failure!.replace(/\.$/, '');
  return [`${which} is reduced by shape and triangle quality alone, because its modes failed: ${why}`];
}

/** Larger residuals |K phi - lambda M phi| / (lambda |M phi|) are reported. */
const GOOD_RESIDUAL = 1e-7;
/** A residual estimates the relative error of an eigenvalue: above this, a frequency may be off by more than 0.5 %. */
const BAD_RESIDUAL = 0.01;

/** A clause on the coarse copy that modes were solved on, or on large residuals; empty if there is nothing to say. */
export function describeSolve(modes: { residual: number }[], coarseVertices: number): Note[] {
  if (coarseVertices === 0) return describeResiduals(modes).map((clause) => [clause]);
  const copy = `a copy with ${counted(coarseVertices, 'vertex', 'vertices')}`;
  return [[`the modes come from ${copy} (`, { setting: 'exact' }, ' solves the mesh itself)']];
}

/** One clause where residuals are large; otherwise none. */
export function describeResiduals(modes: { residual: number }[]): string[] {
  const worst = modes.reduce((largest, { residual }) => Math.max(largest, residual), 0);
  if (worst <= GOOD_RESIDUAL) return [];
  const count = modes.filter(({ residual }) => residual > BAD_RESIDUAL).length;
  const lost =
    count === 0
      ? 'their last digits are rounding errors'
      : `${counted(count, 'mode consists', 'modes consist')} of rounding errors`;
  return [`the largest residual of the modes is ${worst.toExponential(1)}: with needle triangles ${lost}`];
}
