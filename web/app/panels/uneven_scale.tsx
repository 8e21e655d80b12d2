/** The warning about non-uniform scales of nodes with a solver, as on the command line. */

import { results, wants } from '../state/store';
import { listed, say } from '../language/say';

export function UnevenScale() {
  const { bodies } = results.file.value!;
  const uneven = bodies.filter(({ isScaledUnevenly, health }) => isScaledUnevenly && health !== null);
  if (wants.settings.value.solver === 'none' || uneven.length === 0) return null;
  return (
    <p class="hint warning">
      {say(
        '{bodies}: the node scales the mesh non-uniformly, so mesh and masses for the solver get the mean scale and another shape than in the scene. Apply that scale in the modelling program first.',
        { bodies: listed(uneven.map(({ name }) => name)) },
      )}
    </p>
  );
}
