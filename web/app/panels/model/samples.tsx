/** The samples that come with the page. */

import { signal } from '@preact/signals';
import { openAddress } from '../../files/files';
import type { Wanted } from '../../state/link';

export interface Sample {
  id: string;
  name: string;
  file: string;
  faces: number;
  vertices: number;
  about: string;
}

export const samples = signal<Sample[]>([]);

/** Reads the list of samples, which the build makes; none where it is missing. */
export async function loadSamples(): Promise<void> {
  const response = await fetch('./samples/index.json');
  if (response.ok) samples.value = (await response.json()) as Sample[];
}

export const openSample = ({ file }: Sample, wanted?: Wanted): Promise<void> =>
  openAddress(`./samples/${file}`, file, wanted);

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
