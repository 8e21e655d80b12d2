/**
 * How the page learns that a worker has ended, also while it computes and cannot answer: the worker has a lock of the
 * browser for as long as it lives, and the page waits for the same lock.
 */

/** Called in the worker. Resolves once the worker has the lock; where there are no locks, at once. */
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
