/** A colour map with its ends named. */

import { gradient } from '../viewer/colours';
import type { MapName } from '../viewer/colours';
import './colour_bar.css';

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
        <span class="muted">{low}</span>
        <span class="bar-title">{title}</span>
        <span class="muted">{high}</span>
      </span>
      <span class="colours" style={{ background: gradient(map) }} />
    </div>
  );
}
