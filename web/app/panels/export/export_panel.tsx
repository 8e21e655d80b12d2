/** The contents of the exported files, what they omit, the verdict of the validator, and the buttons that save them. */

import { useEffect, useRef } from 'preact/hooks';
import { exportedKey, exportRequest } from '../../state/export_request';
import { exportFormatOf } from '../../worker/export_form';
import { results, wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { Section } from '../../controls/controls';
import { useHeadingFocus } from '../../controls/heading_focus';
import { count, fileSize } from '../../controls/numbers';
import { QueueSection } from '../queue/queue_section';
import { Records, SaveButtons } from './actions';
import { DragOut } from './drag_out';
import { FormSection } from './form_section';
import { LevelsSection } from './levels_section';
import { PresetSection } from './preset_section';
import { SolverSection } from './solver_section';
import { Verdict } from './verdict';
import './export_panel.css';
import { listed, say, sayCounted, sentence } from '../../language/say';

/** The files that are shown and saved; null while they belong to earlier settings. */
const currentExport = (): ExportResult | null =>
  results.exported.value?.key === exportedKey() ? results.exported.value : null;

export function ExportPanel() {
  const file = results.file.value;
  const exported = currentExport();
  const panel = useRef<HTMLElement>(null);
  const heading = useHeadingFocus();
  // On a small screen the panel opens below the part of the page that is in view.
  useEffect(() => panel.current?.scrollIntoView({ block: 'start' }), []);
  if (!file) return null;
  return (
    <aside class="panel right export" aria-label={say('Export')} ref={panel}>
      <div class="panel-head">
        <h2 ref={heading} tabIndex={-1}>
          {say('Export')}
        </h2>
        <button
          type="button"
          class="quiet"
          aria-label={say('Close the export panel')}
          onClick={() => (wants.exportOpen.value = false)}
        >
          {say('Close')}
        </button>
      </div>
      <QueueSection />
      <Section title={exportRequest().output}>
        <p>{describeFile(exported)}</p>
        <SaveButtons exported={exported} />
        <DragOut exported={exported} />
        <FormSection />
      </Section>
      <LossSection dropped={exported?.lost ?? file.dropped} isKnown={exported !== null} />
      <PresetSection />
      <LevelsSection exported={exported} />
      <SolverSection report={exported?.report ?? null} />
      {exported && <Verdict exported={exported} />}
      <Records exported={exported} />
    </aside>
  );
}

const describeFile = (exported: ExportResult | null): string =>
  exported
    ? say('{faces} faces with {content}, {size}.', {
        faces: count(exported.faces),
        content: carriedWords(),
        size: fileSize(exported.bytes.length),
      })
    : say('Writing and checking ...');

/** The contents of the file apart from its faces: "positions, normals, 1 UV set and 2 skins". */
function carriedWords(): string {
  const { contents } = results.file.value!;
  const { isGltf, hasTextures } = exportFormatOf(wants.settings.value);
  const uvSets = isGltf ? contents.uvSets : Math.min(1, contents.uvSets);
  const words = [
    say('positions'),
    say('normals'),
    several(uvSets, '{count} UV set', '{count} UV sets'),
    contents.vertexColours ? say('colours') : '',
    several(hasTextures ? contents.textures : 0, '{count} texture', '{count} textures'),
    ...(isGltf
      ? [
          several(contents.skins, '{count} skin', '{count} skins'),
          several(contents.morphTargets, '{count} morph target', '{count} morph targets'),
          several(contents.animations, '{count} animation', '{count} animations'),
        ]
      : []),
  ];
  return listed(words.filter((word) => word !== ''));
}

/** The number of things; '' for none. */
const several = (number: number, one: string, other: string): string =>
  number > 0 ? sayCounted(number, one, other) : '';

/** `isKnown`: whether the file has been written and checked, so that the list of losses is complete. */
function LossSection({ dropped, isKnown }: { dropped: string[]; isKnown: boolean }) {
  return (
    <Section title="Left out">
      {dropped.length === 0 && (
        <p class="hint">{isKnown ? say('Nothing in the file is lost.') : say('Writing and checking ...')}</p>
      )}
      {dropped.length > 0 && (
        <ul class="note-list">
          {dropped.map((text) => (
            <li key={text} class="limit">
              {sentence(text)}
            </li>
          ))}
        </ul>
      )}
    </Section>
  );
}
