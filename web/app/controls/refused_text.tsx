/** The sentence below a text that was refused. The text field refers to it by `aria-describedby`. */

import type { Refusal } from '../state/refusal';
import { sentence } from '../language/say';

export function RefusedText({ id, refused }: { id: string; refused: Refusal | null }) {
  if (!refused) return null;
  return (
    <p id={id} class="hint bad" role="alert">
      {sentence(refused.why)}
    </p>
  );
}
