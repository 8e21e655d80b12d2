/** The buttons that open the samples. */

import { openSample, samples } from '../../files/samples';
import { say } from '../../language/say';

export function Samples() {
  return (
    <div class="choice" role="group" aria-label={say('Samples')}>
      {samples.value.map((sample) => (
        <button
          key={sample.id}
          type="button"
          title={`${say(sample.name)}: ${say(sample.about)}`}
          onClick={() => void openSample(sample)}
        >
          {say(sample.id)}
        </button>
      ))}
    </div>
  );
}
