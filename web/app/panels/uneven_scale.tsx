/** What a solver makes of meshes that their nodes scale unevenly, as on the command line. */

import { results, wants } from '../state/store';
import { listed, say } from '../language/say';

export function UnevenScale() {
  const { bodies } = results.file.value!;
  const uneven = bodies.filter(({ isScaledUnevenly, health }) => isScaledUnevenly && health !== null);
  if (wants.settings.value.solver === 'none' || uneven.length === 0) return null;
  return (
    <p class="hint warning">
      {say(
        '{bodies}: mesh and masses for the solver have the mean of the scale of the node, and so another shape than the scene. Apply that scale in the modelling program first.',
        { bodies: listed(uneven.map(({ name }) => name)) },
      )}
    </p>
  );
}
