/** In which solver both bodies move, and whether the optimized one has what tuning found for it. */

import { profileOf, SOLVER_NAMES } from '../../../engine/solvers/profiles';
import type { SolverName } from '../../../engine/solvers/profiles';
import type { Settings } from '../../../engine/settings/options';
import { changeSettings, wants } from '../../state/store';
import { twin, usedTuning } from '../../state/twin';
import { Choice, Select } from '../../controls/controls';

/** What moves without a solver of the panel. */
const OWN: Record<Settings['material'], string> = { shell: "Limber's shell", springs: "The paper's springs" };

export function SolverSelect() {
  const { solver, material } = wants.settings.value;
  const options = [
    { value: 'none', text: OWN[material] },
    ...SOLVER_NAMES.map((name) => ({ value: name, text: profileOf(name).label })),
  ];
  return (
    <>
      <Select
        label="Solver"
        title={titleOf(solver)}
        options={options}
        value={solver}
        onChange={(value) => changeSettings({ solver: value as Settings['solver'] })}
      />
      {solver !== 'none' && <Tuning solver={solver} />}
    </>
  );
}

function titleOf(solver: Settings['solver']): string {
  if (solver === 'none') return 'What both bodies are made of: see Simulated as, under More.';
  const { words, status } = profileOf(solver);
  const known = status === 'derived' ? ' Derived from its documents, not checked against the engine.' : '';
  return `Both bodies are ${words}, solved here by XPBD.${known}`;
}

const NOT_TUNED = 'Nothing has been tuned for this solver yet.';

function Tuning({ solver }: { solver: SolverName }) {
  const isTuned = twin.tunedBody.value?.solver === solver;
  const options = [
    { value: 'as it is', text: 'As it is', title: 'The same numbers for both' },
    {
      value: 'tuned',
      text: 'Tuned',
      title: isTuned ? 'The masses and factors that were found for the optimized mesh' : NOT_TUNED,
      disabled: !isTuned,
    },
  ] as const;
  return (
    <div class="control">
      <span>Optimized</span>
      <Choice
        label="Optimized mesh"
        options={options}
        value={usedTuning.value ? 'tuned' : 'as it is'}
        onChange={(choice) => (twin.prefersTuned.value = choice === 'tuned')}
      />
    </div>
  );
}
