/** The warnings about scales of nodes with a solver, as on the command line. */

import type { OpenedBody } from '../worker/protocol';
import { results, wants } from '../state/store';
import { listed, say } from '../language/say';

type Scaling = 'isScaledUnevenly' | 'isScaledDifferently';

const WARNINGS: Record<Scaling, string> = {
  isScaledUnevenly:
    '{bodies}: the node scales the mesh non-uniformly, so mesh and masses for the solver get the mean scale and another shape than in the scene. Apply that scale in the modelling program first.',
  isScaledDifferently:
    '{bodies}: the scene shows the mesh at several scales, but mesh, masses and settings for the solver are for that of its first node. Give copies of another scale a mesh of their own.',
};

export function ScaleWarnings() {
  if (wants.settings.value.solver === 'none') return null;
  const { bodies } = results.file.value!;
  return <>{(Object.keys(WARNINGS) as Scaling[]).map((scaling) => warningOf(bodies, scaling))}</>;
}

/** null where no usable body is scaled so. */
function warningOf(bodies: OpenedBody[], scaling: Scaling) {
  const names = bodies.filter((body) => body[scaling] && body.health !== null).map(({ name }) => name);
  if (names.length === 0) return null;
  return (
    <p key={scaling} class="hint warning">
      {say(WARNINGS[scaling], { bodies: listed(names) })}
    </p>
  );
}
