/** Whether the substeps are enough for what is being compared: measured on demand, told in one sentence. */

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

const TITLE = 'Runs the scenario again in the background, and the original once more with twice the substeps';

export function ConvergenceCheck() {
  const check = convergenceCheck.value;
  return (
    <div class="convergence">
      {isCheckingConvergence.value ? (
        <button type="button" onClick={endConvergenceCheck}>
          Cancel the check
        </button>
      ) : (
        <button
          type="button"
          title={TITLE}
          disabled={!shownMesh.value}
          onClick={() => void checkConvergence()}
        >
          Check substeps
        </button>
      )}
      <p class="hint" role="status">
        {isCheckingConvergence.value ? 'Checking ...' : (check?.failure ?? '')}
      </p>
      {check?.convergence && <Finding {...check.convergence} />}
    </div>
  );
}

function Finding(found: Convergence) {
  const sentence = describeConvergence(found, (substeps) => `take ${count(substeps)}`);
  if (!sentence)
    return (
      <p class="hint">
        Enough: {count(found.substeps)} more would move the original by {percent(found.substepDeviation)},
        beside the {percent(found.deviationMean)} that are judged.
      </p>
    );
  const wanted = substepsToTake(found);
  return (
    <>
      <p class="hint">{sentence}</p>
      <button type="button" onClick={() => changeSettings({ substeps: wanted })}>
        Take {count(wanted)}
      </button>
    </>
  );
}
