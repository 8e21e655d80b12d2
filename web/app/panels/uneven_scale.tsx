/** The warnings about scales of nodes with a solver, as on the command line. */

import { results, wants } from '../state/store';
import { listed, say } from '../language/say';

export function UnevenScale() {
  const { bodies } = results.file.value!;
  if (wants.settings.value.solver === 'none') return null;
  const moved = bodies.filter(({ health }) => health !== null);
  const uneven = moved.filter(({ isScaledUnevenly }) => isScaledUnevenly).map(({ name }) => name);
  const different = moved.filter(({ isScaledDifferently }) => isScaledDifferently).map(({ name }) => name);
  return (
    <>
      {uneven.length > 0 && (
        <p class="hint warning">
          {say(
            '{bodies}: the node scales the mesh non-uniformly, so mesh and masses for the solver get the mean scale and another shape than in the scene. Apply that scale in the modelling program first.',
            { bodies: listed(uneven) },
          )}
        </p>
      )}
      {different.length > 0 && (
        <p class="hint warning">
          {say(
            '{bodies}: the scene shows the mesh at several scales, but mesh, masses and settings for the solver are for that of its first node. Give copies of another scale a mesh of their own.',
            { bodies: listed(different) },
          )}
        </p>
      )}
    </>
  );
}
