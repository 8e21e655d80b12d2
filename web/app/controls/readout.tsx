/** A number with its name above and a note beside it. */

import './readout.css';
import { say } from '../language/say';

interface ReadoutProps {
  name: string;
  value: string;
  note: string;
  isBad?: boolean;
}

export function Readout({ name, value, note, isBad }: ReadoutProps) {
  return (
    <div class={isBad ? 'bad' : undefined}>
      <dt>{say(name)}</dt>
      <dd>
        <strong>{value}</strong>
        <span class="muted">{note}</span>
      </dd>
    </div>
  );
}
