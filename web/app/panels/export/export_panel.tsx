/** What the files will contain, what they leave out, what the validator finds, and the buttons that save them. */

import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { knownMessages } from '../../../engine/document/facts/known_messages';
import type { Validation } from '../../../engine/document/validate';
import type { Compression } from '../../../engine/core/output_words';
import { OPTIONS, checkSetting } from '../../../engine/settings/options';
import { reportAsCsv, reportAsMarkdown } from '../../../engine/report/report_text';
import { readSetting } from '../../../engine/settings/setting_text';
import { commandLine } from '../../command_line';
import { download } from '../../files/files';
import { refusalOf } from '../../state/refusal';
import type { Refusal } from '../../state/refusal';
import { exportedKey, exportRequest } from '../../state/runner';
import { client } from '../../state/running';
import { changeSettings, results, wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { Section, Select, Toggle } from '../../controls/controls';
import { count, fileSize } from '../../controls/numbers';
import { RefusedText } from '../../controls/refused_text';
import { SolverSection } from './solver_section';
import './export_panel.css';
import { listed, say, sayCounted, sentence } from '../../language/say';

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
  const { output } = exportRequest();
  return (
    <aside class="panel right export" aria-label={say('Export')} ref={panel}>
      <div class="panel-head">
        <h2>{say('Export')}</h2>
        <button
          type="button"
          class="quiet"
          aria-label={say('Close the export panel')}
          onClick={() => (wants.exportOpen.value = false)}
        >
          {say('Close')}
        </button>
      </div>
      <Section title={output}>
        <p>{describeFile(exported)}</p>
        <Extras />
      </Section>
      <SolverSection report={exported?.report ?? null} />
      <LeftOut dropped={file.dropped} />
      {exported && <Verdict exported={exported} />}
      <Actions exported={exported} />
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

/** What the file carries besides its faces: "positions, normals, 1 UV set and 2 skins". */
function carriedWords(): string {
  const { contents } = results.file.value!;
  const words = [
    say('positions'),
    say('normals'),
    several(contents.uvSets, '{count} UV set', '{count} UV sets'),
    contents.vertexColours ? say('colours') : '',
    several(contents.textures, '{count} texture', '{count} textures'),
    several(contents.skins, '{count} skin', '{count} skins'),
    several(contents.morphTargets, '{count} morph target', '{count} morph targets'),
    several(contents.animations, '{count} animation', '{count} animations'),
  ];
  return listed(words.filter((word) => word !== ''));
}

/** The number of things; '' for none. */
const several = (number: number, one: string, other: string): string =>
  number > 0 ? sayCounted(number, one, other) : '';

function LeftOut({ dropped }: { dropped: string[] }) {
  return (
    <Section title="Left out">
      {dropped.length === 0 && <p class="hint">{say('Nothing in the file is lost.')}</p>}
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

const COMPRESSION_NAMES: Record<string, string> = {
  'like-input': 'as in the file',
  none: 'none',
  quantized: 'quantized',
  meshopt: 'meshopt',
  draco: 'Draco',
};

function Extras() {
  return (
    <>
      <Toggle
        label="Strain and curvature as attributes"
        checked={wants.exportFields.value}
        onChange={(checked) => (wants.exportFields.value = checked)}
      />
      <Toggle
        label="Binding of the original's vertices"
        checked={wants.exportBinding.value}
        onChange={(checked) => (wants.exportBinding.value = checked)}
      />
      <Select
        label={OPTIONS.compress.label}
        options={OPTIONS.compress.choices.map((value) => ({
          value,
          text: COMPRESSION_NAMES[value] ?? value,
        }))}
        value={wants.settings.value.compress}
        onChange={(compress) => changeSettings({ compress: compress as Compression })}
      />
      <Levels />
    </>
  );
}

/** The text field for the shares of faces of further levels, separated by commas. */
function Levels() {
  const id = useId();
  const [refused, setRefused] = useState<Refusal | null>(null);
  const change = (typed: string) => {
    const text = typed.replaceAll(/\s/g, '');
    const lods = text === '' ? [] : (readSetting(OPTIONS.lods, text) as number[]);
    const refusal = refusalOf(typed, () => checkSetting('lods', lods));
    setRefused(refusal);
    if (!refusal) changeSettings({ lods });
  };
  return (
    <div class="control stacked">
      <label for={id}>{say(OPTIONS.lods.label)}</label>
      <input
        id={id}
        type="text"
        autocomplete="off"
        placeholder="0.25, 0.1"
        title={say('Shares of the faces, separated by commas: one more file for each')}
        aria-invalid={refused !== null}
        aria-describedby={refused ? `${id}-refused` : undefined}
        value={refused ? refused.text : wants.settings.value.lods.join(', ')}
        onChange={(event) => change(event.currentTarget.value)}
      />
      <RefusedText id={`${id}-refused`} refused={refused} />
    </div>
  );
}

const describeVerdict = ({ errors, warnings }: Validation): string =>
  errors === 0 && warnings === 0
    ? say('No errors, no warnings.')
    : say('{errors} errors, {warnings} warnings.', { errors, warnings });

function Verdict({ exported }: { exported: ExportResult }) {
  const { errors, messages } = exported.validation;
  return (
    <Section title="Khronos validator">
      <p class={errors > 0 ? 'verdict bad' : 'verdict good'}>{describeVerdict(exported.validation)}</p>
      <KnownMessages exported={exported} />
      {messages.length > 0 && (
        <ul class="hint">
          {messages.slice(0, 5).map((message) => (
            <li key={message}>{message}</li>
          ))}
        </ul>
      )}
      {exported.levels.length > 0 && (
        <ul class="levels">
          {exported.levels.map(({ name, faces, bytes, validation }) => (
            <li key={name}>
              <span class="filename">{name}</span>
              <span class="muted">
                {say('{faces} faces, {size}.', { faces: count(faces), size: fileSize(bytes.length) })}{' '}
                <span class={validation.errors > 0 ? 'verdict bad' : 'verdict good'}>
                  {describeVerdict(validation)}
                </span>
              </span>
            </li>
          ))}
        </ul>
      )}
    </Section>
  );
}

/** How much of what the validator says it said of the input, too. */
function KnownMessages({ exported: { validation, inputValidation } }: { exported: ExportResult }) {
  const { length: all } = validation.messages;
  if (all === 0 || !inputValidation) return null;
  const known = knownMessages(validation, inputValidation);
  return (
    <p class="hint">
      {known === all
        ? say('All of them were in your file.')
        : say('{known} of {all} were in your file.', { known: count(known), all: count(all) })}
    </p>
  );
}

function Actions({ exported }: { exported: ExportResult | null }) {
  const { output, binding } = exportRequest();
  const { lods, solver } = wants.settings.value;
  const hasMore = binding || solver !== 'none' || lods.length > 0;
  return (
    <div class="actions">
      <button
        type="button"
        class={hasMore ? undefined : 'primary'}
        disabled={!exported}
        onClick={() => download(output, exported!.bytes, 'model/gltf-binary')}
      >
        {say('Save .glb')}
      </button>
      {hasMore && (
        <button
          type="button"
          class="primary"
          disabled={!exported}
          onClick={() => void saveAll(exported!, output)}
        >
          {say('Save all as .zip')}
        </button>
      )}
      {solver !== 'none' && (
        <button
          type="button"
          disabled={!exported}
          onClick={() => download(settingsName(output), exported!.settings!, 'application/json')}
        >
          {say('Save settings')}
        </button>
      )}
      <SaveReport exported={exported} output={output} />
      {exported && <CommandLine exported={exported} />}
    </div>
  );
}

/** The command that writes the same file. */
function CommandLine({ exported: { faces: written, targetFaces: faces } }: { exported: ExportResult }) {
  const { output, binding, fields } = exportRequest();
  const [isCopied, setCopied] = useState(false);
  const line = commandLine(wants.settings.value, results.file.value!.name, output, {
    faces,
    fields,
    binding: binding ? bindingName(output) : null,
    settings: wants.settings.value.solver === 'none' ? null : settingsName(output),
    isMissed: written > faces,
  });
  const copy = () => navigator.clipboard.writeText(line).then(() => setCopied(true));
  return (
    <>
      <button type="button" onClick={() => void copy()}>
        {isCopied ? say('Copied') : say('Copy command line')}
      </button>
      <code class="command">{line}</code>
      {wants.own.value.size > 0 && (
        <p class="hint">
          {say(
            'The command shares the faces out over all meshes: it has no numbers of faces for single ones.',
          )}
        </p>
      )}
    </>
  );
}

const REPORTS = [
  {
    text: 'JSON',
    ending: 'json',
    type: 'application/json',
    write: (report: object) => JSON.stringify(report, null, 2),
  },
  { text: 'CSV', ending: 'csv', type: 'text/csv', write: reportAsCsv },
  { text: 'Markdown', ending: 'md', type: 'text/markdown', write: reportAsMarkdown },
] as const;

function SaveReport({ exported, output }: { exported: ExportResult | null; output: string }) {
  return (
    <div class="reports" role="group" aria-label={say('Save report')}>
      <span>{say('Report')}</span>
      {REPORTS.map(({ text, ending, type, write }) => (
        <button
          key={ending}
          type="button"
          disabled={!exported}
          aria-label={say('Save report as {format}', { format: text })}
          onClick={() => download(output.replace(/glb$/, ending), write(exported!.report), type)}
        >
          {text}
        </button>
      ))}
    </div>
  );
}

const settingsName = (output: string): string => output.replace(/glb$/, 'settings.json');
const bindingName = (output: string): string => output.replace(/glb$/, 'bind.json');

/** Saves the file, its levels, the binding, the settings and the report in one archive. */
async function saveAll(exported: ExportResult, output: string): Promise<void> {
  const text = (content: string) => new TextEncoder().encode(content);
  const files: Record<string, Uint8Array> = {
    [output]: exported.bytes,
    ...Object.fromEntries(exported.levels.map(({ name, bytes }) => [name, bytes])),
    ...(exported.binding === null ? {} : { [bindingName(output)]: text(exported.binding) }),
    ...(exported.settings === null ? {} : { [settingsName(output)]: text(exported.settings) }),
    [output.replace(/glb$/, 'json')]: text(JSON.stringify(exported.report, null, 2)),
  };
  const archive = await client.aside<Uint8Array>((worker) => worker.pack(files));
  download(output.replace(/glb$/, 'zip'), archive, 'application/zip');
}
