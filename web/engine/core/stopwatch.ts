/** Times between calls. */

/** The returned function gives the seconds since its last call, at first since the start. */
export function startStopwatch(): () => number {
  let last = performance.now();
  return () => {
    const now = performance.now();
    const seconds = (now - last) / 1000;
    last = now;
    return seconds;
  };
}
