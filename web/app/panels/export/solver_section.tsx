/** Where the result will move: the solver for which it is tuned, the user's parameters there, and the result of the tuning. */

import { useId, useState } from 'preact/hooks';
import type { Report } from '../../../engine/report/report';
import { describeTuning } from '../../../engine/report/solver_report';
import { engineText, engineValues } from '../../../engine/settings/engine_text';
import { OPTIONS } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { profileOf, SOLVER_NAMES } from '../../../engine/solvers/profiles';
import type { SolverName } from '../../../engine/solvers/profiles';
import type { NativeParameter } from '../../../engine/solvers/profile';
import { Choice, Section, Select } from '../../controls/controls';
import { RefusedText } from '../../controls/refused_text';
import { refusalOf } from '../../state/refusal';
import type { Refusal } from '../../state/refusal';
import { changeSettings, wants } from '../../state/store';
import { ScaleWarnings } from '../scale_warnings';
import { say, sentence } from '../../language/say';

const SOLVERS = [
  { value: 'none', text: 'Not specified' },
  ...SOLVER_NAMES.map((name) => ({ value: name, text: profileOf(name).label })),
];

/** `report`: of the export that is shown; null while unknown. */
export function SolverSection({ report }: { report: Report | null }) {
  const { solver } = wants.settings.value;
  return (
    <Section title={OPTIONS.solver.label}>
      <Select
        label="Solver"
        options={SOLVERS}
        value={solver}
        title="The result's stiffness and masses are tuned so that it moves like the original in this solver"
        onChange={(value) =>
          changeSettings({
            solver: value as Settings['solver'],
            engine: '',
            tune: 'global',
            massRule: 'auto',
          })
        }
      />
      {solver !== 'none' && <Tuning solver={solver} report={report} />}
      <ScaleWarnings />
    </Section>
  );
}

const TUNES = [
  { value: 'global', text: 'Two numbers', title: 'One factor on stretching and one on bending' },
  { value: 'vertex', text: 'Maps', title: 'Smooth factors at the vertices' },
  { value: 'constraint', text: 'Each', title: 'A factor for every spring, triangle and hinge' },
] as const;

function Tuning({ solver, report }: { solver: SolverName; report: Report | null }) {
  const { takes, parameters } = profileOf(solver);
  const found = report?.fidelity?.solvers?.[solver];
  return (
    <>
      <Choice
        label={OPTIONS.tune.label}
        options={TUNES.filter(({ value }) => value !== 'constraint' || takes.constraintValues)}
        value={wants.settings.value.tune}
        onChange={(tune) => changeSettings({ tune })}
      />
      <details class="more">
        <summary>{say(OPTIONS.engine.label)}</summary>
        <p class="hint">
          {say('The values that you use for the original; empty fields follow from the material.')}
        </p>
        {parameters.map((parameter) => (
          <Parameter key={`${solver} ${parameter.name}`} solver={solver} parameter={parameter} />
        ))}
      </details>
      {found ? (
        <ul class="hint tuning">
          {describeTuning(solver, found).map((clause) => (
            <li key={clause}>{sentence(`${clause[0].toUpperCase()}${clause.slice(1)}.`)}</li>
          ))}
        </ul>
      ) : (
        <p class="hint">
          {say('Solving both bodies in {solver} ...', { solver: say(profileOf(solver).label) })}
        </p>
      )}
    </>
  );
}

/** A field for one of the engine's numbers; empty: its default. */
function Parameter({ solver, parameter }: { solver: SolverName; parameter: NativeParameter }) {
  const id = useId();
  const [refused, setRefused] = useState<Refusal | null>(null);
  const { name, unit, words } = parameter;
  const given = engineValues(solver, wants.settings.value.engine);
  const change = (typed: string) => {
    const others = Object.fromEntries(Object.entries(given).filter(([key]) => key !== name));
    const text = [engineText(others), ...(typed.trim() === '' ? [] : [`${name}=${typed.trim()}`])]
      .filter((part) => part !== '')
      .join(',');
    const refusal = refusalOf(typed, () => engineValues(solver, text));
    setRefused(refusal);
    if (!refusal) changeSettings({ engine: text });
  };
  return (
    <div class="control" title={say(words)}>
      <label for={id}>{name}</label>
      <span class="number">
        <input
          id={id}
          type="text"
          inputMode="decimal"
          autocomplete="off"
          aria-invalid={refused !== null}
          aria-describedby={refused ? `${id}-refused` : undefined}
          value={refused ? refused.text : (given[name] ?? '')}
          onChange={(event) => change(event.currentTarget.value)}
        />
        {unit !== '' && <span class="unit">{unit}</span>}
      </span>
      <RefusedText id={`${id}-refused`} refused={refused} />
    </div>
  );
}
