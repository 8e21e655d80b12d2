/** The buttons that save the result and its companion files, and the command that writes the same. */

import type { Settings } from '../../../engine/settings/options';
import { reportAsCsv, reportAsMarkdown } from '../../../engine/report/report_text';
import { commandLine } from '../../command_line';
import { CopyButton } from '../../controls/copy_button';
import { download } from '../../files/files';
import { exportFormatOf, exportSettings } from '../../worker/export_form';
import { exportRequest } from '../../state/export_request';
import { client, complain } from '../../state/running';
import { results, wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { say } from '../../language/say';

/** The main actions of the panel. */
export function SaveButtons({ exported }: { exported: ExportResult | null }) {
  const { output, binding } = exportRequest();
  const { lods, solver } = wants.settings.value;
  const { ending, type } = exportFormatOf(wants.settings.value);
  const hasFiles = lods.length > 0 && exportSettings(wants.settings.value).lodStyle === 'files';
  const hasMore = binding || solver !== 'none' || hasFiles;
  return (
    <div class="actions">
      <button
        type="button"
        class={hasMore ? undefined : 'primary'}
        disabled={!exported}
        onClick={() => download(output, exported!.bytes, type)}
      >
        {say('Save {ending}', { ending })}
      </button>
      {hasMore && (
        <button
          type="button"
          class="primary"
          disabled={!exported}
          onClick={() => void saveAll(exported!, output).catch(complain)}
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
    </div>
  );
}

/** The files that document how the result was made. */
export function Records({ exported }: { exported: ExportResult | null }) {
  return (
    <div class="actions">
      <SaveReport exported={exported} output={exportRequest().output} />
      {exported && <CommandLine exported={exported} />}
    </div>
  );
}

/** The settings as the command needs them: the file name determines the format, and excluded bodies have to be named. */
function asTyped(): Settings {
  const settings = exportSettings(wants.settings.value);
  const refused = results.file.value!.dropped.filter((text) => text.startsWith(extension));
  const names = refused.map((text) => text.slice(extension.length)).join('|');
  return { ...settings, format: 'auto', dropExtensions: settings.dropExtensions || names };
}

const extension = 'extension ';

/** The command that writes the same file. */
function CommandLine({ exported: { faces: written, targetFaces: faces } }: { exported: ExportResult }) {
  const { output, binding, fields } = exportRequest();
  const line = commandLine(asTyped(), results.file.value!.name, output, {
    faces,
    fields,
    binding: binding ? bindingName(output) : null,
    settings: wants.settings.value.solver === 'none' ? null : settingsName(output),
    isMissed: written > faces,
  });
  return (
    <>
      <CopyButton text={say('Copy command line')} write={() => line} />
      <code class="command">{line}</code>
      {wants.own.value.size > 0 && (
        <p class="hint">
          {say(
            'The command distributes the faces over all meshes: it cannot set the number of faces of a single mesh.',
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
          onClick={() => download(`${stem(output)}.${ending}`, write(exported!.report), type)}
        >
          {text}
        </button>
      ))}
    </div>
  );
}

const stem = (output: string): string => output.replace(/(\.(glb|gltf|obj|ply))?(\.zip)?$/, '');
const settingsName = (output: string): string => `${stem(output)}.settings.json`;
const bindingName = (output: string): string => `${stem(output)}.bind.json`;

/** Saves the file, its levels, the binding, the settings and the report in one archive. */
async function saveAll(exported: ExportResult, output: string): Promise<void> {
  const text = (content: string) => new TextEncoder().encode(content);
  const files: Record<string, Uint8Array> = {
    [output]: exported.bytes,
    ...Object.fromEntries(exported.levels.map(({ name, bytes }) => [name, bytes])),
    ...(exported.binding === null ? {} : { [bindingName(output)]: text(exported.binding) }),
    ...(exported.settings === null ? {} : { [settingsName(output)]: text(exported.settings) }),
    [`${stem(output)}.json`]: text(JSON.stringify(exported.report, null, 2)),
  };
  const archive = await client.aside<Uint8Array>((worker) => worker.pack(files));
  download(`${stem(output)}.zip`, archive, 'application/zip');
}
