/** Step 1: what the file contains and what state it is in. */

import { results, wants } from '../../state/store';
import { showBody } from '../../state/runner';
import { Section, SettingRange } from '../../controls/controls';
import { count, fixed } from '../../controls/numbers';
import './model_panel.css';

export function ModelFacts() {
  const file = results.file.value;
  const body = results.body.value;
  if (!file) return null;
  return (
    <>
      <Section title="File">
        <p class="filename" title={file.name}>
          {file.name}
        </p>
        {file.bodies.length > 1 && <Bodies />}
      </Section>
      {body && (
        <>
          <Section title="Mesh">
            <Facts />
          </Section>
          <Section title="Health">
            <Health />
          </Section>
        </>
      )}
    </>
  );
}

function Bodies() {
  return (
    <ul class="bodies">
      {results.file.value!.bodies.map((body, i) => (
        <li key={i}>
          <button type="button" aria-pressed={wants.body.value === i} onClick={() => showBody(i)}>
            <span>{body.name}</span>
            <span class="muted">{count(body.faces)}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}

function Facts() {
  const { inspection, diagonal, minAngle, meanMinAngle } = results.body.value!;
  const rows: [string, string][] = [
    ['Faces', count(inspection.faces)],
    ['Vertices', count(inspection.vertices)],
    ['Parts', count(inspection.components)],
    ['Open borders', count(inspection.boundaryLoops)],
    ['Handles', inspection.genus === null ? 'n/a' : count(inspection.genus)],
    ['Size', `${Number(diagonal.toPrecision(4))} units`],
    ['Smallest angle', `${fixed(minAngle, 1)}°`],
    ['Mean of smallest', `${fixed(meanMinAngle, 1)}°`],
  ];
  return (
    <dl class="facts">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function Health() {
  const { health } = results.body.value!;
  if (health.length === 0) return <p class="hint">Nothing to repair.</p>;
  return (
    <ul class="note-list">
      {health.map(({ kind, text }) => (
        <li key={text} class={kind}>
          {text}
        </li>
      ))}
    </ul>
  );
}

/** How the file is read. */
export function ReadingPanel() {
  return (
    <Section title="Reading" hint="The unit changes frequencies, not the mesh.">
      <SettingRange name="unit" />
      <SettingRange name="weld" />
    </Section>
  );
}
