/** The samples that come with the page. */

import { signal } from '@preact/signals';
import type { Wanted } from '../state/link';
import { wantedOfSample } from '../state/samples/sample_settings';
import { wants } from '../state/store';
import { openAddress } from './files';

export interface Sample {
  id: string;
  name: string;
  file: string;
  faces: number;
  vertices: number;
  about: string;
}

export const samples = signal<Sample[]>([]);

/** Reads the list of samples, which the build writes. Without a list there are no samples. */
export async function loadSamples(): Promise<void> {
  try {
    const response = await fetch('./samples/index.json');
    if (response.ok) samples.value = (await response.json()) as Sample[];
  } catch {
    // The network is down, or the host answers with another page. What the page opens at its start does not depend on
    // the list.
  }
}

/** `asked`: the request of a link, which replaces the sample's own settings. */
export const openSample = ({ file }: Sample, asked?: Wanted): Promise<void> =>
  openAddress(`./samples/${file}`, file, { asked, fresh: wantedOfSample(file, wants.settings.value) });
