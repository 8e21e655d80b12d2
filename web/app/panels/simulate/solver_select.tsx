/** In which solver both bodies move, and whether the optimized one has what tuning found for it. */

import { profileOf, SOLVER_NAMES } from '../../../engine/solvers/profiles';
import type { Settings } from '../../../engine/settings/options';
import { changeSettings, status, wants } from '../../state/store';
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
        onChange={(value) =>
          changeSettings({
            solver: value as Settings['solver'],
            engine: '',
            tune: 'global',
            massRule: 'auto',
          })
        }
      />
      {solver !== 'none' && <Tuning />}
    </>
  );
}

function titleOf(solver: Settings['solver']): string {
  if (solver === 'none') return 'What both bodies are made of: see Simulated as, under More.';
  const { words, status } = profileOf(solver);
  const known = status === 'derived' ? ' Derived from its documents, not checked against the engine.' : '';
  return `Both bodies are ${words}, solved here by XPBD.${known}`;
}

const TUNINGS = [
  { value: 'as it is', text: 'As it is', title: 'The same numbers for both' },
  { value: 'tuned', text: 'Tuned', title: 'The masses and factors with which it moves like the original' },
] as const;

/** Tuning takes a while, so it starts when it is asked for. */
function Tuning() {
  const isWanted = twin.wantsTuned.value;
  return (
    <>
      <div class="control">
        <span>Optimized mesh</span>
        <Choice
          label="Optimized mesh"
          options={TUNINGS}
          value={isWanted ? 'tuned' : 'as it is'}
          onChange={(choice) => (twin.wantsTuned.value = choice === 'tuned')}
        />
      </div>
      {isWanted && !usedTuning.value && (
        <p class="hint">{status.working.value ? 'Tuning ...' : 'It could not be tuned: shown as it is.'}</p>
      )}
    </>
  );
}
