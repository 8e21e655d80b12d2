/** The page before a file is open: what it is for, an area to drop a file, and the samples. */

import { useEffect, useRef } from 'preact/hooks';
import { pickFiles } from '../../files/files';
import { openSample, samples } from '../../files/samples';
import type { Sample } from '../../files/samples';
import { status } from '../../state/store';
import { count } from '../../controls/numbers';
import { SampleCards } from '../../viewer/sample_cards';
import { isMotionReduced } from '../../state/scheme';
import './start_screen.css';

export function StartScreen() {
  if (status.busy.value) return null;
  return (
    <div class="start">
      <div class="start-drop">
        <h2>Fewer triangles that still move right</h2>
        <p>
          Drop a mesh here: Limber finds how it bends and swings, and removes faces where that does not show.
        </p>
        <button type="button" class="primary" onClick={() => void pickFiles()}>
          Open a file
        </button>
        <p class="muted">
          GLB, glTF with its files, OBJ, STL or PLY. <strong>Your file stays on this computer.</strong>
        </p>
      </div>
      {samples.value.length > 0 && <Cards />}
    </div>
  );
}

function Cards() {
  const list = useRef<HTMLUListElement>(null);
  useEffect(() => {
    const canvases = [...list.current!.querySelectorAll('canvas')];
    const addresses = samples.value.map(({ file }) => `./samples/${file}`);
    const cards = SampleCards.open(addresses, canvases, isMotionReduced());
    return () => cards?.dispose();
  }, [samples.value]);
  return (
    <section class="start-samples" aria-label="Or try a sample">
      <h3>Or try a sample</h3>
      <ul class="cards" ref={list}>
        {samples.value.map((sample) => (
          <li key={sample.id}>
            <Card sample={sample} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Card({ sample }: { sample: Sample }) {
  return (
    <button type="button" class="card" onClick={() => void openSample(sample)}>
      <canvas width={440} height={300} aria-hidden="true" />
      <strong>{sample.name}</strong>
      <span class="muted">{count(sample.faces)} faces</span>
      <span>{sample.about}</span>
    </button>
  );
}
