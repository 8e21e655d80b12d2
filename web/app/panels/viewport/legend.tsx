/** How the mesh is drawn, and the legend of its colours. */

import { signal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { spellModes } from '../../../engine/core/mode_set';
import { chooseField, isFileDrawn, results, shownField, view } from '../../state/store';
import type { FieldName, LookName } from '../../state/store';
import { ColourBar } from '../../controls/colour_bar';
import { Choice, Select, Toggle } from '../../controls/controls';
import { curvatureScale } from './curvature_scale';
import { guidingModes } from '../motion/mode_choice';
import { SimulateLegend } from '../simulate/simulate_legend';
import { isWireShown } from './show_bodies';
import './legend.css';
import { say, sentence } from '../../language/say';

const FIELDS: { value: FieldName; text: string; title: string }[] = [
  { value: 'none', text: 'Plain', title: 'No colours (C)' },
  { value: 'strain', text: 'Strain', title: 'Strain of the chosen modes (C)' },
  { value: 'curvature', text: 'Curvature', title: 'Mean curvature (C)' },
];

export const FIELD_NAMES = FIELDS.map(({ value }) => value);

const LOOKS: { value: LookName; text: string }[] = [
  { value: 'textured', text: 'Materials' },
  { value: 'matcap', text: 'Matcap' },
  { value: 'clay', text: 'Clay' },
  { value: 'checker', text: 'UV checker' },
];

/** A window that has no room beside the colours for the look, which stands in the menu then. */
const phone = matchMedia('(max-width: 600px), (max-width: 900px) and (max-height: 560px)');
const isPhone = signal(phone.matches);
phone.addEventListener('change', () => (isPhone.value = phone.matches));

export function Legend() {
  if (!results.body.value) return null;
  if (view.step.value === 'test') return <SimulateLegend />;
  const isShort = isPhone.value && shownField.value === 'none';
  return (
    <div class={isShort ? 'legend short' : 'legend'}>
      <Choice label="Colour by" options={FIELDS} value={shownField.value} onChange={chooseField} />
      <Scale />
      {isFileDrawn.value && !isPhone.value && <LookSelect />}
      <ViewMenu key={view.step.value} />
    </div>
  );
}

/** Closed by a click elsewhere and by Escape, which then does nothing else. */
function ViewMenu() {
  const menu = useRef<HTMLDetailsElement>(null);
  // Preact ends other effects only after the next picture, when the menu may be gone.
  useLayoutEffect(() => {
    const close = (event: PointerEvent): void => {
      if (!menu.current!.contains(event.target as Node)) menu.current!.open = false;
    };
    const escape = (event: KeyboardEvent): void => {
      if (event.key !== 'Escape' || !menu.current!.open) return;
      event.stopPropagation();
      menu.current!.open = false;
      menu.current!.querySelector('summary')!.focus();
    };
    // Runs before the tools of the canvas, which stop the events that they handle.
    document.addEventListener('pointerdown', close, { capture: true });
    document.addEventListener('keydown', escape, { capture: true });
    return () => {
      document.removeEventListener('pointerdown', close, { capture: true });
      document.removeEventListener('keydown', escape, { capture: true });
    };
  }, []);
  return (
    <details class="view-menu" ref={menu}>
      <summary>{say('View')}</summary>
      <div class="view-choices">
        <Toggles />
      </div>
    </details>
  );
}

function Toggles() {
  const { contents, bodies } = results.file.value!;
  const isFile = isFileDrawn.value && results.originalFile.value !== null;
  return (
    <>
      {isFileDrawn.value && isPhone.value && <LookSelect />}
      <Toggle label="Flat" checked={view.isFlat.value} onChange={(flat) => (view.isFlat.value = flat)} />
      <Toggle label="Wireframe" checked={isWireShown()} onChange={(wire) => (view.wire.value = wire)} />
      {view.step.value === 'reduce' && (
        <Toggle
          label="Swing"
          title="Swings both meshes in the chosen modes (Space)"
          checked={view.swings.value}
          onChange={(swings) => (view.swings.value = swings)}
        />
      )}
      {isFile && bodies.length > 1 && (
        <Toggle
          label="Whole scene"
          checked={view.isWhole.value}
          onChange={(whole) => (view.isWhole.value = whole)}
        />
      )}
      {isFile && contents.animations > 0 && (
        <Toggle
          label="Animation"
          title="Plays the first animation of the file on both meshes"
          checked={view.animated.value}
          onChange={(animated) => (view.animated.value = animated)}
        />
      )}
    </>
  );
}

/** The looks for which the file has data. */
function LookSelect() {
  const { contents } = results.file.value!;
  return (
    <Select
      label="Look"
      options={LOOKS.filter(({ value }) => value !== 'checker' || contents.uvSets > 0)}
      value={view.look.value}
      onChange={(look) => (view.look.value = look as LookName)}
    />
  );
}

function Scale() {
  const curvature = results.curvature.value?.vertex;
  const { diagonal } = results.body.value!;
  if (shownField.value === 'strain')
    return <ColourBar map="viridis" title={strainTitle()} low="least" high="most" />;
  if (shownField.value === 'curvature' && curvature) {
    const high = (curvatureScale(curvature) * diagonal).toPrecision(2);
    return <ColourBar map="cividis" title="Mean curvature x diagonal" low="0" high={high} />;
  }
  return null;
}

function strainTitle(): string {
  const modes = guidingModes();
  return modes.length === 1
    ? say('Strain rank, mode {mode}', { mode: modes[0] })
    : say('Strain rank, modes {modes}', { modes: sentence(spellModes(modes)) });
}
