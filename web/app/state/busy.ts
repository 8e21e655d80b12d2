/** Says what is going on, how far it is, and for how long. */

import type { Client } from './client';
import { status } from './store';

const SLOW_MILLISECONDS = 200;

/** Shows what is going on while `make` runs, unless it is quick. */
export async function whileBusy<T>(
  client: Pick<Client, 'progress'>,
  what: string,
  make: () => Promise<T>,
): Promise<T> {
  let frame = 0;
  let begin = performance.now();
  let phase = '';
  const show = () => {
    const progress = client.progress();
    const now = performance.now();
    const own = progress?.part ? 'bodies' : (progress?.phase ?? '');
    if (own !== phase) [phase, begin] = [own, now];
    status.busy.value = { what, progress, seconds: (now - begin) / 1000 };
    frame = requestAnimationFrame(show);
  };
  const timer = setTimeout(show, SLOW_MILLISECONDS);
  try {
    return await make();
  } finally {
    clearTimeout(timer);
    cancelAnimationFrame(frame);
    status.busy.value = null;
  }
}

/** Shows what has gone wrong. */
export function complain(error: unknown): void {
  status.notice.value = { kind: 'error', text: error instanceof Error ? error.message : String(error) };
}
