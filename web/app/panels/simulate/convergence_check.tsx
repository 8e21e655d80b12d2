/** Whether the substeps suffice for the comparison: measured on demand, reported in one sentence. */

import { describeConvergence, substepsToTake } from '../../../engine/motion/convergence';
import type { Convergence } from '../../../engine/motion/convergence';
import {
  checkConvergence,
  convergenceCheck,
  endConvergenceCheck,
  isCheckingConvergence,
} from '../../state/convergence';
import { changeSettings, shownMesh } from '../../state/store';
import { count, percent } from '../../controls/numbers';
import './convergence_check.css';
import { say, sentence } from '../../language/say';

const TITLE = 'Runs the scenario again in the background, and the original once more with twice the substeps';

export function ConvergenceCheck() {
  const check = convergenceCheck.value;
  return (
    <div class="convergence">
      {isCheckingConvergence.value ? (
        <button type="button" onClick={endConvergenceCheck}>
          {say('Cancel the check')}
        </button>
      ) : (
        <button
          type="button"
          title={say(TITLE)}
          disabled={!shownMesh.value}
          onClick={() => void checkConvergence()}
        >
          {say('Check substeps')}
        </button>
      )}
      <p class="hint" role="status">
        {isCheckingConvergence.value ? say('Checking ...') : sentence(check?.failure ?? '')}
      </p>
      {check?.convergence && <Finding {...check.convergence} />}
    </div>
  );
}

function Finding(found: Convergence) {
  const finding = describeConvergence(found, (substeps) => say('take {count}', { count: count(substeps) }));
  if (!finding)
    return (
      <p class="hint">
        {say(
          'Enough: {count} more would move the original by {moved}, which is little compared with the deviation of {judged}.',
          {
            count: count(found.substeps),
            moved: percent(found.substepDeviation),
            judged: percent(found.deviationMean),
          },
        )}
      </p>
    );
  const wanted = substepsToTake(found);
  return (
    <>
      <p class="hint">{sentence(finding)}</p>
      <button type="button" onClick={() => changeSettings({ substeps: wanted })}>
        {say('Take {count}', { count: count(wanted) })}
      </button>
    </>
  );
}
