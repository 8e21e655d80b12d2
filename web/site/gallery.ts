/** The gallery: originals and results that can be turned, at rest and in motion. */

import type { SceneLook } from '../app/viewer/file/scene_model';
import { Stage } from './stage';
import { TurningView } from './turning_view';

/** Radians a second, until somebody turns a model. */
const ROTATION_SPEED = 0.25;

const isDark = matchMedia('(prefers-color-scheme: dark)');
const wires = document.querySelector<HTMLInputElement>('#wires')!;
const looks = document.querySelector<HTMLSelectElement>('#look')!;
const playing = document.querySelector<HTMLInputElement>('#playing')!;
const trouble = document.querySelector('#trouble')!;

function chosenLook(): SceneLook {
  return {
    name: looks.value as SceneLook['name'],
    isFlat: false,
    clay: isDark.matches ? '#a79d91' : '#c3b8ab',
    wire: '#10202e',
    wireStrength: wires.checked ? 0.35 : 0,
    shown: null,
  };
}

/** Draws the views that are there, frame by frame. */
function animate(views: readonly TurningView[], stage: Stage): void {
  const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
  let isTouched = isStill;
  playing.checked = !isStill;
  for (const event of ['pointerdown', 'keydown']) addEventListener(event, () => (isTouched = true));
  let [before, seconds] = [performance.now(), 0];
  const frame = (time: number): void => {
    const step = Math.min(0.1, (time - before) / 1000);
    before = time;
    if (playing.checked) seconds += step;
    for (const view of views) {
      if (!isTouched && !view.isMoving) view.rotate(-ROTATION_SPEED * step, 0);
      if (playing.checked) view.pose(seconds);
      view.draw(stage);
    }
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

async function show(): Promise<void> {
  const stage = await Stage.open();
  const views: TurningView[] = [];
  const relook = (): void => views.forEach((view) => view.look(chosenLook()));
  for (const control of [wires, looks, isDark]) control.addEventListener('change', relook);
  animate(views, stage);
  for (const group of document.querySelectorAll('.turning')) {
    const view = await TurningView.load([...group.querySelectorAll('canvas')]);
    view.look(chosenLook());
    view.pose(0);
    views.push(view);
  }
  // The next frame draws what was read last.
  await new Promise(requestAnimationFrame);
  document.body.dataset.shown = String(views.length);
}

show().catch((error: unknown) => {
  trouble.textContent = `The models cannot be shown here: ${error instanceof Error ? error.message : String(error)}`;
});
