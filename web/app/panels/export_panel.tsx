/** What the file will hold, what it leaves out, what the validator says, and the save. */

import { useState } from 'preact/hooks';
import { commandLine } from '../command_line';
import { download } from '../files';
import { bodyTargets } from '../state/runner';
import { results, wants } from '../state/store';
import { Section, Toggle, count } from './controls';

const baseName = (name: string): string =>
  name
    .split('/')
    .pop()!
    .replace(/\.[^.]+$/, '');

export function ExportPanel() {
  const file = results.file.value;
  const exported = results.exported.value;
  if (!file) return null;
  const output = `${baseName(file.name)}-limber.glb`;
  return (
    <aside class="panel export" aria-label="Export">
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
      <Section title={output}>
        <p>
          {exported
            ? `${count(exported.faces)} faces with positions and normals, ${size(exported.bytes.length)}.`
            : 'Writing and checking ...'}
        </p>
        <Toggle
          label="Strain and curvature as attributes"
          checked={wants.exportFields.value}
          onChange={(checked) => (wants.exportFields.value = checked)}
        />
      </Section>
      <Section title="Left out">
        {file.dropped.length === 0 ? (
          <p class="hint">Nothing that the file holds is lost.</p>
        ) : (
          <ul class="health">
            {file.dropped.map((text) => (
              <li key={text} class="limit">
                {text}
              </li>
            ))}
          </ul>
        )}
      </Section>
      <Verdict />
      <Actions output={output} />
    </aside>
  );
}

function Verdict() {
  const exported = results.exported.value;
  if (!exported) return null;
  const { errors, warnings, messages } = exported.validation;
  return (
    <Section title="Khronos validator">
      <p class={errors > 0 ? 'verdict bad' : 'verdict good'}>
        {errors === 0 && warnings === 0
          ? 'No errors, no warnings.'
          : `${errors} errors, ${warnings} warnings.`}
      </p>
      {messages.length > 0 && (
        <ul class="hint">
          {messages.slice(0, 5).map((message) => (
            <li key={message}>{message}</li>
          ))}
        </ul>
      )}
    </Section>
  );
}

function Actions({ output }: { output: string }) {
  const exported = results.exported.value;
  const [copied, setCopied] = useState(false);
  const line = commandLine(wants.settings.value, results.file.value!.name, output, {
    faces: bodyTargets().reduce((sum, faces) => sum + faces, 0),
    fields: wants.exportFields.value,
  });
  const copy = () => navigator.clipboard.writeText(line).then(() => setCopied(true));
  return (
    <div class="actions">
      <button
        type="button"
        class="primary"
        disabled={!exported}
        onClick={() => download(output, exported!.bytes, 'model/gltf-binary')}
      >
        Save .glb
      </button>
      <button
        type="button"
        disabled={!exported}
        onClick={() =>
          download(
            output.replace(/glb$/, 'json'),
            JSON.stringify(exported!.report, null, 2),
            'application/json',
          )
        }
      >
        Save report
      </button>
      <button type="button" onClick={() => void copy()}>
        {copied ? 'Copied' : 'Copy command line'}
      </button>
      <code class="command">{line}</code>
    </div>
  );
}

const size = (bytes: number): string =>
  bytes < 1e6 ? `${Math.round(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
