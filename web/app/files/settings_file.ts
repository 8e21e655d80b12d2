/** Settings files brought back: the solver, its parameters and the number of faces that they were written for. */

import { batch } from '@preact/signals';
import { originalParameters } from '../../engine/report/original_parameters';
import { readSettingsFile } from '../../engine/report/settings_reader';
import type { SettingsFile } from '../../engine/report/settings_file';
import type { SourceFile } from '../../engine/document/open';
import { engineText, engineValues } from '../../engine/settings/engine_text';
import { profileOf } from '../../engine/solvers/profiles';
import { complain } from '../state/running';
import { changeSettings, keepFaces, results, status, view, wants } from '../state/store';
import { twin } from '../state/twin';
import { count, say } from '../language/say';

/** Whether a file is meant to be a settings file: a JSON document that is no report and no part of a model. */
export const isSettingsName = ({ name }: SourceFile): boolean => /\.json$/i.test(name);

/** What a settings file asks of the page. */
export interface AskedBySettings {
  /** a text as of the setting `engine` */
  engine: string;
  /** faces of the first level, of all bodies */
  faces: number;
  /** faces of the original, of all bodies */
  originalFaces: number;
}

/** Throws SettingError where the parameters are out of their range. */
export function askedBy(file: SettingsFile): AskedBySettings {
  const engine = engineText(originalParameters(file));
  engineValues(file.solver, engine);
  const first = file.bodies.filter(({ level }) => level === file.bodies[0].level);
  return {
    engine,
    faces: sum(first.map(({ mesh }) => mesh.triangles.length / 3)),
    originalFaces: sum(first.map(({ original }) => original.faces)),
  };
}

const sum = (values: number[]): number => values.reduce((total, value) => total + value, 0);

/** Takes over what a settings file says, for the model that is open, and shows it moving. */
export function applySettings({ name, bytes }: SourceFile): void {
  try {
    const file = readSettingsFile(name, new TextDecoder().decode(bytes));
    if (!results.body.value)
      throw new Error(
        say('{name} says how a model moves in {solver}: open that model first.', {
          name,
          solver: say(labelOf(file)),
        }),
      );
    show(name, file, askedBy(file));
  } catch (error) {
    complain(error);
  }
}

const labelOf = ({ solver }: SettingsFile): string => profileOf(solver).label;

function show(name: string, file: SettingsFile, { engine, faces, originalFaces }: AskedBySettings): void {
  const { solver, tune, units } = file;
  const rule = file.bodies[0].mass.original ?? 'auto';
  const massRule = rule === profileOf(solver).mass ? 'auto' : rule;
  const { inspection, scale } = results.body.value!;
  const own = inspection.faces;
  const isSame = own === originalFaces;
  batch(() => {
    changeSettings({ solver, tune, engine, massRule, unit: units.length / scale });
    if (isSame) keepFaces(faces);
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
          '{name}: {solver} with its parameters. It was written for a model of {original} faces and this one has {own}, so it is tuned anew.',
          values,
        ),
  };
}
