/** The buttons that open the samples. */

import { openSample, samples } from '../../files/samples';

export function Samples() {
  return (
    <div class="choice" role="group" aria-label="Samples">
      {samples.value.map((sample) => (
        <button
          key={sample.id}
          type="button"
          title={`${sample.name}: ${sample.about}`}
          onClick={() => void openSample(sample)}
        >
          {sample.id}
        </button>
      ))}
    </div>
  );
}
