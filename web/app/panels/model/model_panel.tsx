/** Step 1: the contents and the condition of the file. */

import { changeSettings, results, wants } from '../../state/store';
import { sizeAfter } from '../../state/export_request';
import { Section, SettingRange } from '../../controls/controls';
import { count, fileSize, fixed } from '../../controls/numbers';
import { lengthWords, likelierUnit } from './length';
import { SceneTree } from './scene_tree';
import './model_panel.css';
import { say, sayCounted, sentence } from '../../language/say';

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
        <Contents />
        <FileNotes />
      </Section>
      {file.bodies.length > 1 && (
        <Section title={sayCounted(file.bodies.length, '{count} mesh', '{count} meshes')}>
          <SceneTree />
        </Section>
      )}
      {body && (
        <>
          <Section title="Mesh">
            <Facts />
            <UnitQuestion />
          </Section>
          <Section title="Health">
            <Health />
          </Section>
        </>
      )}
    </>
  );
}

/** The notes of the reader on the file as a whole. */
function FileNotes() {
  const { notes } = results.file.value!;
  if (notes.length === 0) return null;
  return (
    <ul class="note-list hint">
      {notes.map((note) => (
        <li key={note}>{sentence(note)}</li>
      ))}
    </ul>
  );
}

/** The facts about a file that matter to an artist. */
function Contents() {
  const { contents, size } = results.file.value!;
  const after = sizeAfter.value;
  const rows: [string, string][] = [
    ['File size', after === null ? fileSize(size) : `${fileSize(size)} → ${fileSize(after)}`],
    ['UV sets', count(contents.uvSets)],
    ['Materials', count(contents.materials)],
    ['Textures', count(contents.textures)],
    ['Vertex colours', contents.vertexColours ? say('yes') : say('no')],
    ['Skins', count(contents.skins)],
    ['Animations', count(contents.animations)],
    ['Morph targets', count(contents.morphTargets)],
  ];
  return <FactList rows={rows} />;
}

function Facts() {
  const { inspection, diagonal, scale, minAngle, meanMinAngle } = results.body.value!;
  const units = say('{size} units', { size: Number((diagonal * scale).toPrecision(4)) });
  const rows: [string, string][] = [
    ['Faces', count(inspection.faces)],
    ['Vertices', count(inspection.vertices)],
    ['Parts', count(inspection.components)],
    ['Open borders', count(inspection.boundaryLoops)],
    ['Handles', inspection.genus === null ? say('n/a') : count(inspection.genus)],
    ['Diagonal', `${units} = ${lengthWords(diagonal * scale * wants.settings.value.unit)}`],
    ['Smallest angle', `${fixed(minAngle, 1)}°`],
    ['Mean of smallest', `${fixed(meanMinAngle, 1)}°`],
  ];
  return <FactList rows={rows} />;
}

function FactList({ rows }: { rows: [string, string][] }) {
  return (
    <dl class="facts">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{say(name)}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

/** A file does not specify its unit; a model in centimetres, read as metres, would be as heavy and slow as a house. */
function UnitQuestion() {
  const { diagonal, scale } = results.body.value!;
  const likelier = likelierUnit(diagonal * scale, wants.settings.value.unit);
  if (!likelier) return null;
  const { unit, name } = likelier;
  return (
    <div class="buttons">
      <button type="button" onClick={() => changeSettings({ unit })}>
        {say('Is it in {unit}?', { unit: say(name) })}
      </button>
    </div>
  );
}

function Health() {
  const { health } = results.body.value!;
  if (health.length === 0) return <p class="hint">{say('Nothing to repair.')}</p>;
  return (
    <ul class="note-list">
      {health.map(({ kind, text }) => (
        <li key={text} class={kind}>
          {sentence(text)}
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
