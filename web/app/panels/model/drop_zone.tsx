/** The page before a file is open: an area to drop one, and the samples. */

import { pickFiles } from '../../files/files';
import { status } from '../../state/store';
import { count } from '../../controls/numbers';
import { openSample, samples } from '../../files/samples';
import './drop_zone.css';

export function DropZone() {
  if (status.busy.value) return null;
  return (
    <div class="drop-zone">
      <h2>Drop a mesh here</h2>
      <p class="muted">GLB, glTF with its files, OBJ, STL or PLY. Your file stays on this computer.</p>
      <button type="button" class="primary" onClick={() => void pickFiles()}>
        Open a file
      </button>
      <ul class="cards">
        {samples.value.map((sample) => (
          <li key={sample.id}>
            <button type="button" onClick={() => void openSample(sample)}>
              <strong>{sample.name}</strong>
              <span class="muted">{count(sample.faces)} faces</span>
              <span>{sample.about}</span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
