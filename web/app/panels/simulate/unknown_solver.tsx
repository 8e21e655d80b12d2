/** For users who do not know where the result will move: a description, what to choose in plain words, and settings for all solvers. */

import { useEffect } from 'preact/hooks';
import { profileOf } from '../../../engine/solvers/profiles';
import type { GenericSolver } from '../../../engine/solvers/profiles';
import { download } from '../../files/files';
import { say } from '../../language/say';
import { baseName, genericKey } from '../../state/export_request';
import { suffixedName } from '../../state/queue/model_groups';
import { results, shownMesh } from '../../state/store';
import { twin } from '../../state/twin';
import './unknown_solver.css';

/** The parameters that programs ask for, and examples of such programs. */
const ASKED: readonly { value: GenericSolver; text: string }[] = [
  { value: 'shell', text: 'Stiffness and thickness of the material, as for rubber or cloth' },
  { value: 'hinge-shell', text: 'Stiffness of its faces, and bending stiffness at its edges' },
  { value: 'dihedral', text: 'Stretching of edges, and bending as an angle between faces: Houdini, Unreal' },
  { value: 'springs', text: 'Springs only, for stretching and for bending: Unity, Godot' },
];

export function UnknownSolver({ onChoose }: { onChoose(solver: GenericSolver): void }) {
  return (
    <>
      <p class="hint">
        {say(
          'The result keeps shape, outline and pins. Any engine can use it, but its stiffness and masses are not tuned for one.',
        )}
      </p>
      <table class="solver-table">
        <thead>
          <tr>
            <th scope="col">{say('If your program asks for')}</th>
            <th scope="col">{say('choose')}</th>
          </tr>
        </thead>
        <tbody>
          {ASKED.map(({ value: solver, text }) => (
            <tr key={solver}>
              <th scope="row">{say(text)}</th>
              <td>
                <button type="button" onClick={() => onChoose(solver)}>
                  {say(profileOf(solver).label)}
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <SaveForAll />
    </>
  );
}

/** Tuning takes a while, so it only starts on request; its result is saved at once. */
function SaveForAll() {
  const { wantsGeneric } = twin;
  const { value: files } = results.genericFiles;
  useEffect(() => {
    if (!wantsGeneric.value || files?.key !== genericKey()) return;
    wantsGeneric.value = false;
    download(
      `${suffixedName(baseName(results.file.value!.name))}-any-engine.zip`,
      files.archive,
      'application/zip',
    );
  }, [wantsGeneric.value, files]);
  return (
    <>
      <p class="hint">
        {say('Or save the model with the numbers for each of the four, and try which of them fits.')}
      </p>
      <button
        type="button"
        disabled={!shownMesh.value || wantsGeneric.value}
        onClick={() => (wantsGeneric.value = true)}
      >
        {wantsGeneric.value ? say('Tuning ...') : say('Save all four as .zip')}
      </button>
    </>
  );
}
