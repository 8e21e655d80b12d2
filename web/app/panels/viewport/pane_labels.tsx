/** What each pane of the viewport shows. */

import { viewportColours } from '../../state/scheme';
import { results, shownMesh, view } from '../../state/store';
import type { PaneName } from '../../viewer/pane_layout';
import { labelsBesideChoice } from '../reduce/compare';
import { isDriven, isOverlaid } from '../simulate/simulate_view';
import { sceneFaces, shownPanes } from './show_bodies';
import './pane_labels.css';
import { say, sayCounted } from '../../language/say';

function faceCount(name: PaneName): string {
  const mesh = name === 'original' ? results.body.value?.mesh : shownMesh.value?.mesh;
  const faces = sceneFaces(name) ?? (mesh?.triangles.length ?? 0) / 3;
  return sayCounted(faces, '{count} face', '{count} faces');
}

export function PaneLabels() {
  if (view.step.value === 'test' && shownMesh.value) return <TwinLabels />;
  return (
    <div class={`pane-labels ${labelsBesideChoice()}`}>
      {shownPanes().map((name) => (
        <span key={name}>
          {name === 'original' ? say('Original') : say('Optimized')}{' '}
          <span class="muted">{faceCount(name)}</span>
        </span>
      ))}
    </div>
  );
}

function TwinLabels() {
  return (
    <div class="pane-labels">
      <span>
        {say('Original')} <span class="muted">{faceCount('original')}</span>
      </span>
      <span>
        {isOverlaid.value && <span class="swatch" style={{ background: viewportColours.value.overlay }} />}
        {isDriven.value ? say('Original, carried by the optimized') : say('Optimized')}{' '}
        <span class="muted">{faceCount(isDriven.value ? 'original' : 'optimized')}</span>
      </span>
    </div>
  );
}
