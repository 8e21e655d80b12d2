/** What the files will contain, what they leave out, what the validator finds, and the buttons that save them. */

import { useEffect, useRef } from 'preact/hooks';
import { counted } from '../../../engine/core/words';
import { exportedKey, exportRequest } from '../../state/export_request';
import { exportFormatOf } from '../../worker/export_form';
import { results, wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { Section } from '../../controls/controls';
import { count, fileSize } from '../../controls/numbers';
import { QueueSection } from '../queue/queue_section';
import { Actions } from './actions';
import { DragOut } from './drag_out';
import { FormSection } from './form_section';
import { LevelsSection } from './levels_section';
import { PresetSection } from './preset_section';
import { SolverSection } from './solver_section';
import { Verdict } from './verdict';
import './export_panel.css';

/** The files that are shown and saved; null while they are those of earlier settings. */
const currentExport = (): ExportResult | null =>
  results.exported.value?.key === exportedKey() ? results.exported.value : null;

export function ExportPanel() {
  const file = results.file.value;
  const exported = currentExport();
  const panel = useRef<HTMLElement>(null);
  // On a small screen the panel opens below the part of the page that is in view.
  useEffect(() => panel.current?.scrollIntoView({ block: 'start' }), []);
  if (!file) return null;
  return (
    <aside class="panel right export" aria-label="Export" ref={panel}>
      <div class="panel-head">
        <h2>Export</h2>
        <button
          type="button"
          class="quiet"
          aria-label="Close the export panel"
          onClick={() => (wants.exportOpen.value = false)}
        >
          Close
        </button>
      </div>
      <QueueSection />
      <Section title={exportRequest().output}>
        <p>{describeFile(exported)}</p>
        <DragOut exported={exported} />
        <FormSection />
      </Section>
      <PresetSection />
      <LevelsSection exported={exported} />
      <SolverSection report={exported?.report ?? null} />
      <LeftOut dropped={exported?.lost ?? file.dropped} />
      {exported && <Verdict exported={exported} />}
      <Actions exported={exported} />
    </aside>
  );
}

const describeFile = (exported: ExportResult | null): string =>
  exported
    ? `${count(exported.faces)} faces with ${carriedWords()}, ${fileSize(exported.bytes.length)}.`
    : 'Writing and checking ...';

/** What the file carries besides its faces: "positions, normals, 1 UV set and 2 skins". */
function carriedWords(): string {
  const { contents } = results.file.value!;
  const { isGltf } = exportFormatOf(wants.settings.value);
  const words = [
    'positions',
    'normals',
    counted(contents.uvSets, 'UV set'),
    contents.vertexColours ? 'colours' : '',
    counted(contents.textures, 'texture'),
    ...(isGltf
      ? [
          counted(contents.skins, 'skin'),
          counted(contents.morphTargets, 'morph target'),
          counted(contents.animations, 'animation'),
        ]
      : []),
  ].filter((word) => word !== '' && !word.startsWith('0 '));
  return `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}

function LeftOut({ dropped }: { dropped: string[] }) {
  return (
    <Section title="Left out">
      {dropped.length === 0 && <p class="hint">Nothing in the file is lost.</p>}
      {dropped.length > 0 && (
        <ul class="note-list">
          {dropped.map((text) => (
            <li key={text} class="limit">
              {text}
            </li>
          ))}
        </ul>
      )}
    </Section>
  );
}
