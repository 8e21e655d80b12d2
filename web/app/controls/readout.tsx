/** A number with its name above and a note next to it. */

import './readout.css';
import { say } from '../language/say';

interface ReadoutProps {
  name: string;
  value: string;
  note: string;
  isBad?: boolean;
  /** of value and note together; 'named': as the others, but the value may be truncated instead of the note */
  width?: 'narrow' | 'wide' | 'wider' | 'widest' | 'named';
  /** its position on a phone, counting from 0; the others follow */
  phoneOrder?: number;
}

export function Readout({ name, value, note, isBad, width, phoneOrder }: ReadoutProps) {
  return (
    <div
      class={`${width ?? ''} ${isBad ? 'bad' : ''}`}
      title={`${value} ${note}`}
      style={phoneOrder === undefined ? undefined : { '--phone-order': phoneOrder }}
    >
      <dt>{say(name)}</dt>
      <dd>
        <strong>{value}</strong>
        <span class="muted">{note}</span>
      </dd>
    </div>
  );
}
