/** The solver in which both bodies move, and whether the optimized one is tuned. */

import type { DefaultModel } from '../../../engine/motion/default_model';
import { profileOf, SOLVER_NAMES } from '../../../engine/solvers/profiles';
import type { SolverName } from '../../../engine/solvers/profiles';
import { OPTIONS as SETTINGS } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { changeSettings, status, wants } from '../../state/store';
import { defaultModel, twin, usedTuning } from '../../state/twin';
import { describeTrial } from './trial_text';
import { UnknownSolver } from './unknown_solver';
import { Choice, Select } from '../../controls/controls';
import { ScaleWarnings } from '../scale_warnings';
import { say, sentence } from '../../language/say';

type Material = Settings['material'];

interface Words {
  text: string;
  title: string;
}

export const SHELL: Words = {
  text: "Limber's shell",
  title: 'Membrane and bending: the same material on any mesh',
};

/** What is called solid: closed parts are, and open ones are shells. */
export const SOLID: Record<DefaultModel, Words> = {
  solid: { text: "Limber's solid", title: 'Filled with material in the same way in both bodies' },
  shell: SHELL,
  both: {
    text: "Limber's solid and shell",
    title: 'Closed parts are filled with material in the same way in both bodies; open ones are shells',
  },
};

export const SPRINGS: Words = {
  text: "The paper's springs",
  title: 'Springs along the edges, as in the paper: a different material on every mesh',
};

/** Words for each; a body whose parts are all open is a shell in either way, which is offered once. */
const ownWords = (model: DefaultModel): [Material, Words][] => [
  ['solid', SOLID[model]],
  ...(model === 'shell' ? [] : ([['shell', SHELL]] as [Material, Words][])),
  ['springs', SPRINGS],
];

/** The program's own materials are listed before the solvers of engines, under names that no solver has. */
const ownValue = (material: Material): string => `own ${material}`;

const optionsFor = (words: [Material, Words][]) => [
  ...words.map(([material, { text }]) => ({ value: ownValue(material), text })),
  ...SOLVER_NAMES.map((name) => ({ value: name as string, text: profileOf(name).label })),
  { value: 'unknown', text: "Don't know" },
];

export function SolverSelect() {
  const { solver, material } = wants.settings.value;
  const isUnknown = solver === 'none' && twin.isSolverUnknown.value;
  const words = ownWords(defaultModel.value);
  const [shown, { title }] = words.find(([own]) => own === material) ?? words[0];
  const own = isUnknown ? 'unknown' : ownValue(shown);
  return (
    <>
      <Select
        label="Solver"
        title={solver === 'none' ? title : titleOf(solver)}
        options={optionsFor(words)}
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
    : ownWords(defaultModel.value).find(([own]) => ownValue(own) === value)?.[0];
  const others = { engine: '', tune: 'global', massRule: 'auto' } as const;
  twin.isSolverUnknown.value = isUnknown;
  if (twin.wantsGeneric.value) stopGeneric();
  if (material) changeSettings({ solver: 'none', material, ...others });
  else changeSettings({ solver: value as SolverName, ...others });
}

/** Discards the files for all four solvers, which need the settings without a solver, and says so. */
function stopGeneric(): void {
  twin.wantsGeneric.value = false;
  const run = (): void => {
    status.notice.value = null;
    choose('unknown');
    twin.wantsGeneric.value = true;
  };
  status.notice.value = {
    kind: 'info',
    text: say('“Save all four as .zip” was stopped because another solver was chosen.'),
    action: { label: 'Go back and save all four', run },
  };
}

function titleOf(solver: SolverName): string {
  const { words, status } = profileOf(solver);
  const known =
    status === 'derived' ? say(' Derived from its documentation, not checked against the engine.') : '';
  return say('Both bodies are {words}, solved here by XPBD.', { words: sentence(words) }) + known;
}

/** The evidence for the numbers that are used. */
function Trial() {
  const motion = usedTuning.value?.tuned.motion;
  return motion && <p class="hint">{describeTrial(motion)}</p>;
}

/** What the engine needs, and how to get it. */
function TakeAlong() {
  const { solver } = wants.settings.value;
  if (solver === 'none') return null;
  return (
    <>
      <p class="hint">
        {say('For {solver}, export the model and its settings file, which has the numbers to type in.', {
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
  { value: 'as it is', text: 'Untuned', title: 'The same numbers for both' },
  { value: 'tuned', text: 'Tuned', title: 'The masses and factors with which it moves like the original' },
] as const;

/** Tuning takes a while, so it only starts on request. */
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
          {status.working.value ? say('Tuning ...') : say('It could not be tuned, and is shown untuned.')}
        </p>
      )}
      <Trial />
      <ScaleWarnings />
      <TakeAlong />
    </>
  );
}
