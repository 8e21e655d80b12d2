/** In which solver both bodies move, and whether the optimized one has what tuning found for it. */

import { profileOf, SOLVER_NAMES } from '../../../engine/solvers/profiles';
import type { SolverName } from '../../../engine/solvers/profiles';
import { OPTIONS as SETTINGS } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { changeSettings, status, wants } from '../../state/store';
import { twin, usedTuning } from '../../state/twin';
import { UnknownSolver } from './unknown_solver';
import { Choice, Select } from '../../controls/controls';
import { say, sentence } from '../../language/say';

type Material = Settings['material'];

/** What moves without a solver of the panel. */
const OWN: Record<Material, { text: string; title: string }> = {
  solid: {
    text: "Limber's solid",
    title: 'Closed parts have an inside, the same in both bodies; open ones are shells',
  },
  shell: { text: "Limber's shell", title: 'Membrane and bending: the same material on any mesh' },
  springs: {
    text: "The paper's springs",
    title: 'The edges, as in the paper: another material on every mesh',
  },
};
const OWN_NAMES = Object.keys(OWN) as Material[];

/** Materials of the program stand before the solvers of engines, under names that no solver has. */
const ownValue = (material: Material): string => `own ${material}`;

const OPTIONS = [
  ...OWN_NAMES.map((material) => ({ value: ownValue(material), text: OWN[material].text })),
  ...SOLVER_NAMES.map((name) => ({ value: name as string, text: profileOf(name).label })),
  { value: 'unknown', text: "Don't know" },
];

export function SolverSelect() {
  const { solver, material } = wants.settings.value;
  const isUnknown = solver === 'none' && twin.isSolverUnknown.value;
  const own = isUnknown ? 'unknown' : ownValue(material);
  return (
    <>
      <Select
        label="Solver"
        title={solver === 'none' ? OWN[material].title : titleOf(solver)}
        options={OPTIONS}
        value={solver === 'none' ? own : solver}
        onChange={choose}
      />
      {solver !== 'none' && <Tuning />}
      {isUnknown && <UnknownSolver onChoose={choose} />}
    </>
  );
}

function choose(value: string): void {
  const isUnknown = value === 'unknown';
  const material = isUnknown
    ? (SETTINGS.material.default as Material)
    : OWN_NAMES.find((own) => ownValue(own) === value);
  const others = { engine: '', tune: 'global', massRule: 'auto' } as const;
  twin.isSolverUnknown.value = isUnknown;
  twin.wantsGeneric.value = false;
  if (material) changeSettings({ solver: 'none', material, ...others });
  else changeSettings({ solver: value as SolverName, ...others });
}

function titleOf(solver: SolverName): string {
  const { words, status } = profileOf(solver);
  const known =
    status === 'derived' ? say(' Derived from its documents, not checked against the engine.') : '';
  return say('Both bodies are {words}, solved here by XPBD.', { words: sentence(words) }) + known;
}

/** What the engine needs, and the way to it. */
function TakeAlong() {
  const { solver } = wants.settings.value;
  if (solver === 'none') return null;
  return (
    <>
      <p class="hint">
        {say('For {solver} take the model and its settings file, which has the numbers to type in.', {
          solver: say(profileOf(solver).label),
        })}
      </p>
      <button type="button" onClick={() => (wants.exportOpen.value = true)}>
        {say('Export both')}
      </button>
    </>
  );
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
        <span>{say('Optimized mesh')}</span>
        <Choice
          label="Optimized mesh"
          options={TUNINGS}
          value={isWanted ? 'tuned' : 'as it is'}
          onChange={(choice) => (twin.wantsTuned.value = choice === 'tuned')}
        />
      </div>
      {isWanted && !usedTuning.value && (
        <p class="hint">
          {status.working.value ? say('Tuning ...') : say('It could not be tuned: shown as it is.')}
        </p>
      )}
      <TakeAlong />
    </>
  );
}
