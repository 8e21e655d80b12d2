/** The meshes of the file: their faces before and after, their problems, and whether they are shown and locked. */

import { describeProblems } from './problems';
import { shownResultFile } from '../../state/drawn_file';
import { showBody } from '../../state/runner';
import { results, setFacesOf, view, wants } from '../../state/store';
import type { OpenedBody } from '../../worker/protocol';
import { count } from '../../controls/numbers';
import { say } from '../../language/say';

export function SceneTree() {
  const { bodies } = results.file.value!;
  return (
    <ul class="bodies" aria-label={say('Meshes')}>
      {bodies.map((body, i) => (
        <li key={i} class={wants.body.value === i ? 'body chosen' : 'body'}>
          <Eye body={body} i={i} />
          <button
            type="button"
            class="body-name"
            aria-pressed={wants.body.value === i}
            disabled={body.health === null}
            onClick={() => showBody(i)}
          >
            <span class="body-title" title={body.name}>
              {body.name}
            </span>
            <span class="muted">{describeFaces(body, i)}</span>
          </button>
          <Problems body={body} />
          <Lock body={body} i={i} />
        </li>
      ))}
    </ul>
  );
}

/** The current number of faces, and the exported one if known. */
function describeFaces(body: OpenedBody, i: number): string {
  const after = shownResultFile.value?.faces[i] ?? results.shares.value?.expected[i] ?? 0;
  return after > 0 ? `${count(body.faces)} → ${count(after)}` : count(body.faces);
}

function Eye({ body, i }: { body: OpenedBody; i: number }) {
  const isHidden = view.hidden.value.has(i);
  const toggle = () => {
    const hidden = new Set(view.hidden.value);
    if (isHidden) hidden.delete(i);
    else hidden.add(i);
    view.hidden.value = hidden;
  };
  return (
    <button
      type="button"
      class="quiet icon"
      aria-label={say('Show {name}', { name: body.name })}
      aria-pressed={!isHidden}
      title={isHidden ? say('Show it in the whole scene') : say('Hide it in the whole scene')}
      onClick={toggle}
    >
      <svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
        <path
          d={
            isHidden
              ? 'M2 9c3 3 9 3 12 0M4 11l-1 2M8 11.5v2M12 11l1 2'
              : 'M1.5 8c3-5 10-5 13 0-3 5-10 5-13 0z'
          }
          fill="none"
          stroke="currentColor"
          stroke-width="1.3"
        />
        {!isHidden && <circle cx="8" cy="8" r="2" fill="currentColor" />}
      </svg>
    </button>
  );
}

/** A locked mesh keeps all of its faces. */
function Lock({ body, i }: { body: OpenedBody; i: number }) {
  const isLocked = wants.own.value.get(i) === body.faces;
  return (
    <button
      type="button"
      class="quiet icon"
      aria-label={say('Keep all faces of {name}', { name: body.name })}
      aria-pressed={isLocked}
      title={
        isLocked
          ? say('It keeps all of its faces: click to let it lose some again')
          : say('Keep all of its faces')
      }
      disabled={body.health === null}
      onClick={() => setFacesOf(i, isLocked ? null : body.faces)}
    >
      <svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
        <path
          d={
            isLocked
              ? 'M3.5 7h9v6.5h-9zM5.5 7V5a2.5 2.5 0 0 1 5 0v2'
              : 'M3.5 7h9v6.5h-9zM5.5 7V4.5a2.5 2.5 0 0 1 4.800-1'
          }
          fill={isLocked ? 'currentColor' : 'none'}
          stroke="currentColor"
          stroke-width="1.3"
        />
      </svg>
    </button>
  );
}

function Problems({ body }: { body: OpenedBody }) {
  const text = describeProblems(body);
  if (text === '') return <span />;
  return (
    <span class="problem" role="img" aria-label={text} title={text}>
      !
    </span>
  );
}
