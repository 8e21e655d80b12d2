/** Warnings about a run over a file, for both the command line and the library. */

import { describeFailedModes, describeHealth, describeSize } from '../body/health';
import { materialOf } from '../body/material';
import { otherScales } from '../document/placements';
import { describeLargeFit } from '../report/fit_words';
import { ofBody, ofSentence } from '../report/warnings';
import type { Warning } from '../report/warnings';
import { wordNote } from '../settings/options';
import type { Note, SettingName, Settings } from '../settings/options';
import type { PreparedBody } from '../body/prepared_body';
import type { ModeSet } from '../core/core';
import type { BodyRun } from './body_run';
import type { FileRun } from './file_run';
import type { RunSettings } from './stage';
import { STAGES } from './stages';

/** Prepares the bodies; warns of those that are left unchanged, and of repairs. Throws an Error where no body is usable. */
export function preparedWarnings(file: FileRun, settings: Settings): Warning[] {
  const unusable = file
    .prepare(settings)
    .map((sentence) => ofSentence(`${sentence.replace(/\.$/, '')}; it is left unchanged`));
  const isOneOfMany = file.model.bodies.length > 1;
  const health = file.prepared(settings).flatMap(({ body, weld, inspection }) =>
    describeHealth(body, weld, inspection)
      .filter(({ kind }) => kind !== 'fact')
      .map(({ text, fate }) =>
        ofBody(body.name, fate && file.guides ? `${text} ${fate}` : text, isOneOfMany),
      ),
  );
  if (settings.solver === 'none') return [...unusable, ...health];
  return [...unusable, ...health, ...unevenlyScaled(file, settings), ...differentlyScaled(file, settings)];
}

/** Warnings about non-uniform scales of nodes: a solver moves the mesh itself, which has one unit. */
const unevenlyScaled = (file: FileRun, settings: Settings): Warning[] =>
  file
    .prepared(settings)
    .filter(({ body }) => body.isScaledUnevenly)
    .map(({ body }) =>
      ofBody(
        body.name,
        'its node scales it non-uniformly, so mesh and masses for the solver get the mean scale and another shape than in the scene: apply that scale in the modelling program first',
        file.model.bodies.length > 1,
      ),
    );

/** Warnings about meshes that the scene shows at other scales than that of their first node, which a solver gets. */
const differentlyScaled = (file: FileRun, settings: Settings): Warning[] =>
  file.prepared(settings).flatMap(({ body }) => {
    const { document, bodies } = file.model;
    const range = otherScales(document, body);
    if (!range) return [];
    const [from, to, own] = [range.least, range.most, body.scale].map((one) => Number(one.toPrecision(3)));
    const text = `the scene shows it at scales from ${from} to ${to}, but mesh, masses and settings for the solver are for ${own} alone: give copies of another scale a mesh of their own`;
    return [ofBody(body.name, text, bodies.length > 1)];
  });

/** Warnings about bodies of implausible size in metres. `nameOf`: the reader's names for settings. */
export const sizeWarnings = (
  file: FileRun,
  settings: Settings,
  nameOf: (setting: SettingName) => string,
): Warning[] =>
  file.prepared(settings).flatMap((body) => {
    const size: Note | null = describeSize(body.diagonal * materialOf(body, settings).unit);
    return size ? [ofBody(body.body.name, wordNote(size, nameOf))] : [];
  });

/** Warnings where the result of a body differs from the request. */
export function resultWarnings(run: BodyRun, settings: RunSettings): Warning[] {
  const { name } = run.context.body;
  const { note } = run.get(STAGES.constraints, settings);
  const large = describeLargeFit(run.get(STAGES.fitted, settings));
  return [
    ...(note === '' ? [] : [note]),
    ...describeFailedModes(name, run.get(STAGES.guidingModes, settings)),
    ...(large === '' ? [] : [ofBody(name, large)]),
  ];
}

/**
 * The modes of every body that takes part, and warnings of those that have none. Throws an Error with one sentence where no body has
 * any.
 */
export function modesOfFile(file: FileRun, settings: Settings): { sets: ModeSet[]; warnings: Warning[] } {
  const all = file.usable.map(({ run }) => {
    file.announce(run);
    return { prepared: run.get(STAGES.prepared, settings), set: run.get(STAGES.modes, settings) };
  });
  const immovable = all.filter(({ set }) => set.modes.length === 0).map(({ prepared }) => prepared);
  if (immovable.length === all.length)
    throw new Error(`Body "${immovable[0].body.name}" has no modes: ${explainNoModes(immovable[0])}.`);
  const warnings = immovable.map((body) => ofBody(body.body.name, `no modes: ${explainNoModes(body)}`));
  return { sets: all.map(({ set }) => set), warnings };
}

/** Degrees; triangles with smaller angles count as having no area. */
const NO_ANGLE = 1e-6;

const hasNoArea = ({ quality }: PreparedBody): boolean => quality.meanMinAngle < NO_ANGLE;

/** Warnings about bodies without modes, whose frequency errors of 0 mean nothing. */
export const comparedWarnings = (originals: PreparedBody[]): Warning[] =>
  originals
    .filter(hasNoArea)
    .map(({ body }) => ofBody(body.name, 'no modes to compare: its triangles have no area'));

/** A clause on why a body has no modes, and the cure. */
const explainNoModes = (body: PreparedBody): string =>
  hasNoArea(body)
    ? 'its triangles have no area, so repair the mesh and export it again'
    : 'its pins hold everything that could move, so pin fewer vertices';
