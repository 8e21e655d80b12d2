/** Methods at an equal budget: pictures from one viewpoint, and a table to copy. */

import { useState } from 'preact/hooks';
import { methodChange } from '../../../engine/settings/options';
import { METHOD_TITLES, budgetTable } from '../../../engine/stages/equal_budget/budget_table';
import { COMPARED_METHODS, isOwnMethod } from '../../../engine/stages/equal_budget/equal_budget';
import type { ComparedMethod } from '../../../engine/stages/equal_budget/equal_budget';
import { faceCount } from '../../../engine/core/mesh';
import { useHeadingFocus } from '../../controls/heading_focus';
import { count } from '../../controls/numbers';
import { Spoken } from '../../controls/spoken';
import { comparison, shownComparison } from '../../state/methods';
import { changeSettings, results, status, view, wantedFaces, wants } from '../../state/store';
import { MethodGrid } from './method_grid';
import { MethodTable } from './method_table';
import './methods_panel.css';
import { say } from '../../language/say';

export function MethodsPanel() {
  const body = results.body.value;
  if (!comparison.isOpen.value || view.step.value !== 'reduce' || !body) return null;
  return <OpenPanel original={body.mesh} />;
}

const close = (): void => {
  comparison.isOpen.value = false;
};

function OpenPanel({ original }: { original: { positions: Float32Array; triangles: Uint32Array } }) {
  const [answer, setAnswer] = useState('');
  const heading = useHeadingFocus();
  const compared = shownComparison.value;
  const found = compared?.results ?? [];
  const budget = wantedFaces.value;
  return (
    <section
      class="methods"
      aria-labelledby="methods-title"
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        // Escape closes the panel and does nothing else.
        event.stopPropagation();
        close();
      }}
    >
      <div class="panel-head">
        <h2 id="methods-title" ref={heading} tabIndex={-1}>
          {say('Methods at {faces} faces', { faces: count(budget) })}
        </h2>
        <button type="button" class="quiet" aria-label={say('Close the comparison')} onClick={close}>
          {say('Close')}
        </button>
      </div>
      <p class="hint">
        {say(
          'The same mesh, each at the same number of faces. Drag a picture to turn all of them; click one to use its method.',
        )}{' '}
        <Progress done={found.length} />
      </p>
      <MethodGrid original={original} results={found} onChoose={(name) => setAnswer(choose(name))} />
      {answer && (
        <p class="answer" role="status">
          {answer}
        </p>
      )}
      {found.length > 0 && (
        <MethodTable
          table={budgetTable(found, {
            model: results.file.value!.bodies[wants.body.value].name || results.file.value!.name,
            faces: budget,
            originalFaces: faceCount(original),
          })}
          failures={found.filter(({ failure }) => failure !== '')}
        />
      )}
    </section>
  );
}

function Progress({ done }: { done: number }) {
  const { length: all } = COMPARED_METHODS;
  const text = done === all ? say('All are measured.') : say('{done} of {all} are measured.', { done, all });
  const isStopped = done < all && status.paused.value.includes('Comparing methods');
  return (
    <>
      <strong>{isStopped ? `${text} ${say('Stopped.')}` : text}</strong>
      <Spoken text={text} />
    </>
  );
}

/** Uses a method if Limber has it; otherwise says what can be done. */
function choose(name: ComparedMethod): string {
  if (!isOwnMethod(name))
    return say(
      '{method} is shown only for comparison. Limber shows, tests and saves results of its own methods: choose one of the first three.',
      { method: say(METHOD_TITLES[name]) },
    );
  if (wants.settings.value.method !== name) changeSettings(methodChange(name));
  close();
  return '';
}
