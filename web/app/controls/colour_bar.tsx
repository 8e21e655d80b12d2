/** A colour map with its ends named. */

import { gradient } from '../viewer/colours';

export function ColourBar({
  map,
  title,
  low,
  high,
}: {
  map: 'viridis' | 'cividis';
  title: string;
  low: string;
  high: string;
}) {
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
