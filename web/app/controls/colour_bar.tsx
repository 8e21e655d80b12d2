/** A colour map with its ends named. */

import { gradient } from '../viewer/colours';
import type { MapName } from '../viewer/colours';
import './colour_bar.css';
import { say } from '../language/say';

interface ColourBarProps {
  map: MapName;
  title: string;
  low: string;
  high: string;
}

export function ColourBar({ map, title, low, high }: ColourBarProps) {
  return (
    <div class="bar">
      <span class="ends">
        <span class="muted">{say(low)}</span>
        <span class="bar-title">{say(title)}</span>
        <span class="muted">{say(high)}</span>
      </span>
      <span class="colours" style={{ background: gradient(map) }} />
    </div>
  );
}
