/** Reads settings files back: the solver, its parameters and the number of faces for which they were written. */

import { batch } from '@preact/signals';
import { originalMaterial, originalParameters } from '../../engine/report/original_parameters';
import { readSettingsFile } from '../../engine/report/settings_reader';
import { firstLevel } from '../../engine/report/settings_file';
import type { BodySettings, SettingsFile } from '../../engine/report/settings_file';
import type { Body, SourceFile } from '../../engine/document/open';
import { engineText, engineValues } from '../../engine/settings/engine_text';
import { profileOf } from '../../engine/solvers/profiles';
import { complain } from '../state/running';
import { changeSettings, results, status, view, wants } from '../state/store';
import { twin } from '../state/twin';
import { count, say } from '../language/say';

/** Whether a file is meant to be a settings file: a JSON document that is neither a report nor part of a model. */
export const isSettingsName = ({ name }: SourceFile): boolean => /\.json$/i.test(name);

/** The parameters as a text of the setting `engine`. Throws SettingError if they are out of range. */
function engineAskedBy(file: SettingsFile): string {
  const engine = engineText(originalParameters(file));
  engineValues(file.solver, engine);
  return engine;
}

/** Faces of the first level, of all bodies. */
const facesIn = ({ bodies }: SettingsFile): number =>
  firstLevel(bodies).reduce((sum, { mesh }) => sum + mesh.triangles.length / 3, 0);

/** The entry for the body of this name, of several that of its mesh; in a file with one body, which may have been renamed, its only entry. */
export function entryOf(
  { bodies }: Pick<SettingsFile, 'bodies'>,
  { name, mesh }: Pick<Body, 'name' | 'mesh'>,
): BodySettings | null {
  const first = firstLevel(bodies);
  const named = first.filter((body) => body.name === name);
  const own = named.find(({ meshNumber }) => meshNumber === mesh) ?? named[0];
  return own ?? (first.length === 1 ? first[0] : null);
}

/** How damaged files are made anew: the button is that of the Export step. */
const CURE = 'save it again with “Save settings”';

/** Applies a settings file to the open model and shows the model in motion. */
export function applySettings({ name, bytes }: SourceFile): void {
  try {
    const file = readSettingsFile(name, new TextDecoder().decode(bytes), CURE);
    if (!results.body.value)
      throw new Error(
        say('{name} is a settings file for {solver}: open its model first.', {
          name,
          solver: say(labelOf(file)),
        }),
      );
    show(name, file, engineAskedBy(file));
  } catch (error) {
    complain(error);
  }
}

const labelOf = ({ solver }: SettingsFile): string => profileOf(solver).label;

function show(name: string, file: SettingsFile, engine: string): void {
  const { solver, tune, units } = file;
  const rule = file.bodies[0].mass.original ?? 'auto';
  const massRule = rule === profileOf(solver).mass ? 'auto' : rule;
  const { inspection, scale } = results.body.value!;
  const entry = entryOf(file, results.file.value!.bodies[wants.body.value]);
  const [faces, own] = [facesIn(file), inspection.faces];
  const originalFaces = (entry ?? file).original.faces;
  const isSame = entry !== null && own === originalFaces;
  batch(() => {
    const unit = (entry?.unit ?? units.length) / scale;
    changeSettings({ ...originalMaterial(file), solver, tune, engine, massRule, unit });
    if (isSame) wants.faces.value = faces;
    twin.wantsTuned.value = true;
    wants.exportOpen.value = false;
    view.step.value = 'test';
  });
  const values = {
    name,
    solver: say(labelOf(file)),
    faces: count(faces),
    original: count(originalFaces),
    own: count(own),
  };
  status.notice.value = {
    kind: 'info',
    text: isSame
      ? say('{name}: {solver} with its parameters, {faces} faces.', values)
      : say(
          '{name}: {solver} with its parameters. It was written for a model of {original} faces, but this one has {own}, so it is tuned again.',
          values,
        ),
  };
}
