/**
 * Lets the page detect that a worker has ended, even while it computes and cannot answer: the worker holds a browser
 * lock for its lifetime, and the page waits for the same lock.
 */

/** Called in the worker. Resolves once the worker has the lock; at once if the browser has no locks. */
export function keepAlive(lock: string): Promise<void> {
  if (!navigator.locks) return Promise.resolve();
  return new Promise((resolve) => {
    const untilTheEnd = (): Promise<void> => {
      resolve();
      return new Promise(() => {});
    };
    void navigator.locks.request(lock, untilTheEnd);
  });
}

/** Called in the page, after `keepAlive` has resolved in the worker: calls `onEnd` once the worker has ended. */
export function watchLife(lock: string, onEnd: () => void): void {
  void navigator.locks?.request(lock, () => onEnd());
}
