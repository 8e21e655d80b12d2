// Counts of all suites, a line for each, and the last line of a run.

import { join } from 'node:path';
import { folders } from '../setup/environment.mjs';

/** The folder of the suites' reports. */
export const results = join(folders.build, 'results');

const total = { passed: 0, failed: 0, skipped: 0 };
const skips = (count) => (count ? `, ${count} skipped` : '');

/** Adds the counts of a suite to the totals and prints its line. */
export function add(suite, { passed, failed, skipped }) {
  total.passed += passed;
  total.failed += failed;
  total.skipped += skipped;
  console.log(
    `${failed ? 'FAILED' : 'ok    '} ${suite}: ${passed} passed, ${failed} failed${skips(skipped)}`,
  );
}

/** Prints the line of all suites. Returns the exit code of the run. */
export function printTotals() {
  console.log(`${total.passed} passed, ${total.failed} failed${skips(total.skipped)}`);
  return total.failed ? 1 : 0;
}
