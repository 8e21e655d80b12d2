/** Shows the mesh of the wanted faces at once: the history is replayed in parallel to the tasks of the runner. */

import { computed, effect, signal, untracked } from '@preact/signals';
import type { MeshAt } from '../../engine/core/core';
import { client, complain, replayer } from './running';
import { isHistoryStale, results, status, wantedFaces, wants } from './store';

interface Asked {
  /** of the history, see HistorySummary */
  id: string;
  faces: number;
}

const asked = computed((): Asked | null => {
  const { value: history } = results.history;
  return history && results.body.value ? { id: history.replayId, faces: wantedFaces.value } : null;
});

const shown = signal<Asked | null>(null);

const isSame = (a: Asked | null, b: Asked | null): boolean => a?.id === b?.id && a?.faces === b?.faces;

/** Whether the history's mesh of the wanted faces is available. */
export const isReplayed = computed(
  () => results.mesh.value !== null && asked.value !== null && isSame(shown.value, asked.value),
);

/** From now on, replays whenever the slider moves or the history changes. */
export function startReplay(): void {
  effect(() => {
    if (asked.value && !isReplayed.value) untracked(() => void replay());
  });
}

let isRunning = false;

/** Replays for one position of the slider at a time, then for its position at that time. */
async function replay(): Promise<void> {
  if (isRunning) return;
  isRunning = status.isReplaying.value = true;
  try {
    for (let next = asked.peek(); next && !isReplayed.peek(); next = asked.peek()) {
      const mesh = await meshAt(next);
      // While the slider moves, an intermediate mesh is better than none.
      if (mesh && results.history.peek()?.replayId === next.id) show(mesh, next);
      else if (isSame(next, asked.peek())) break;
    }
  } catch (error) {
    complain(error);
  } finally {
    isRunning = status.isReplaying.value = false;
  }
}

function show(mesh: MeshAt, of: Asked): void {
  shown.value = of;
  results.mesh.value = mesh;
}

/** If the replaying worker cannot be started or has ended, the worker of the tasks takes over for the history of the settings. */
async function meshAt({ id, faces }: Asked): Promise<MeshAt | null> {
  const [body, settings] = [wants.body.peek(), wants.settings.peek()];
  return replayer
    .meshAt(id, faces)
    .catch(() =>
      isHistoryStale.peek() ? null : client.aside<MeshAt>((worker) => worker.meshAt(body, settings, faces)),
    );
}
