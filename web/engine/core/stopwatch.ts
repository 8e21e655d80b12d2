/** A stopwatch. */

/** The returned function returns the seconds since its last call, or since the start on its first call. */
export function startStopwatch(): () => number {
  let last = performance.now();
  return () => {
    const now = performance.now();
    const seconds = (now - last) / 1000;
    last = now;
    return seconds;
  };
}
