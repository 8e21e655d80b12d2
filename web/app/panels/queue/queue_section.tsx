/** The queue of models: its settings, its progress, and the result of each model. */

import { Spoken } from '../../controls/spoken';
import { count, fileSize, percent } from '../../controls/numbers';
import { Section } from '../../controls/controls';
import { download } from '../../files/files';
import { baseName } from '../../state/export_request';
import { exportFormatOf } from '../../worker/export_form';
import { openFiles } from '../../state/runner';
import { client, complain } from '../../state/running';
import { results, slider, wants } from '../../state/store';
import { cancelQueue, closeQueue, queue, runQueue } from '../../state/queue/queue';
import type { Queue, QueueItem } from '../../state/queue/queue';
import { describeOutcome, describeProgress, summaryCsv } from '../../state/queue/summary';
import type { Finished } from '../../state/queue/summary';
import { changedWords } from '../export/setting_values';
import './queue.css';
import { say, sentence } from '../../language/say';

export function QueueSection() {
  if (!queue.value) return null;
  const { items, isRunning } = queue.value;
  return (
    <div class="queue">
      <Section title={say('{number} models', { number: items.length })}>
        <p class="hint">{describeAsked()}</p>
        <Progress queue={queue.value} />
        <div class="buttons">
          {!isRunning && (
            <button type="button" disabled={!results.mesh.value} onClick={() => void runQueue()}>
              {items.some(({ state }) => state === 'done')
                ? say('Run all again')
                : say('Optimize all {number}', { number: items.length })}
            </button>
          )}
          {isRunning && (
            <button type="button" onClick={cancelQueue}>
              {say('Cancel the queue')}
            </button>
          )}
          {items.some(({ finished }) => finished) && (
            <button type="button" class="primary" disabled={isRunning} onClick={() => void saveQueue(items)}>
              {say('Save the queue as .zip')}
            </button>
          )}
          <button type="button" class="quiet" onClick={closeQueue}>
            {say('Close the queue')}
          </button>
        </div>
        <ul class="queue-items">
          {items.map((item) => (
            <Item key={item.name} item={item} />
          ))}
        </ul>
      </Section>
    </div>
  );
}

/** "All with the settings of this page: at most 50 % of the faces, as GLB; Compression: Draco." */
function describeAsked(): string {
  const { wanted, faces } = slider.value;
  const share = faces > 0 ? Math.round((100 * wanted) / faces) : 50;
  const settings = wants.settings.value;
  const format = say(exportFormatOf(settings).text);
  const others = changedWords(settings);
  if (others === '')
    return say('All with the settings of this page: at most {share} % of the faces, as {format}.', {
      share,
      format,
    });
  return say('All with the settings of this page: at most {share} % of the faces, as {format}; {others}.', {
    share,
    format,
    others,
  });
}

function Progress({ queue: { items, isRunning, seconds } }: { queue: Queue }) {
  const ended = items.filter(({ state }) => state === 'done' || state === 'failed').length;
  if (!isRunning && ended === 0) return null;
  const text = isRunning ? describeProgress(items, seconds) : describeOutcome(items);
  return (
    <div class="queue-progress">
      <Spoken text={isRunning ? say('{done} of {all} done', { done: ended, all: items.length }) : text} />
      <span>{text}</span>
      {isRunning && <progress max={items.length} value={ended} aria-label={say('Progress of the queue')} />}
    </div>
  );
}

const STATE_WORDS: Record<QueueItem['state'], string> = {
  waiting: 'waiting',
  running: 'running ...',
  done: 'done',
  failed: 'failed',
};

/** Why a model has more faces than requested. */
const STOP_WORDS: Record<string, string> = {
  deviation: 'stopped by the deviation limit',
  angle: 'stopped by the smallest angle',
  frequency: 'stopped by the frequency limit',
  exhausted: 'no edge left to collapse',
};

function Item({ item: { name, files, state, sentence: problem, finished } }: { item: QueueItem }) {
  return (
    <li class={state}>
      <button
        type="button"
        class="quiet"
        title={say('Show {name}', { name })}
        onClick={() => void openFiles(files)}
      >
        {name}
      </button>
      {finished ? (
        <span class="muted">{describeFinished(finished)}</span>
      ) : (
        <span class={state === 'failed' ? 'verdict bad' : 'muted'}>
          {problem ? sentence(problem) : say(STATE_WORDS[state])}
        </span>
      )}
    </li>
  );
}

const describeFinished = ({ faces, stop, deviation, bytes }: Finished): string =>
  say('{before} → {after} faces{stop}, deviation {deviation}, {size}', {
    before: count(faces.before),
    after: count(faces.after),
    stop: stop === null ? '' : ` (${say(STOP_WORDS[stop] ?? stop)})`,
    deviation: percent(deviation),
    size: fileSize(bytes),
  });

/** Saves all finished models, with a table of the results of each model. */
async function saveQueue(items: readonly QueueItem[]): Promise<void> {
  const files = items.flatMap(({ finished }) => finished?.files ?? []);
  const content = Object.fromEntries(files.map(({ name, bytes }) => [name, bytes]));
  content['summary.csv'] = new TextEncoder().encode(summaryCsv(items));
  try {
    const archive = await client.aside<Uint8Array>((worker) => worker.pack(content));
    download(`${baseName(items[0].name)}-and-${items.length - 1}-more.zip`, archive, 'application/zip');
  } catch (error) {
    complain(error);
  }
}
