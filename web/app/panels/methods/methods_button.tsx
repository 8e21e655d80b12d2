/** The button of the Reduce step that opens the comparison of methods. */

import { comparison } from '../../state/methods';
import { shownMetrics, wants } from '../../state/store';
import { say } from '../../language/say';

export function MethodsButton() {
  return (
    <button
      type="button"
      disabled={!shownMetrics.value}
      aria-expanded={comparison.isOpen.value}
      title={say(
        'Limber, the paper, quadrics and meshoptimizer at the same number of faces: pictures and numbers',
      )}
      onClick={() => {
        wants.exportOpen.value = false;
        comparison.isOpen.value = !comparison.isOpen.value;
      }}
    >
      {say('Compare methods')}
    </button>
  );
}
