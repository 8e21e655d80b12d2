/** Time limits of tests against input that is made to be slow: of processor time, which other work on the machine does not change. */

/** Starts to measure; the function returned gives the seconds of processor time that this process has used since. */
export function processorTime(): () => number {
  const start = process.cpuUsage();
  return () => {
    const { user, system } = process.cpuUsage(start);
    return (user + system) / 1e6;
  };
}
