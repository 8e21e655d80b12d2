#!/usr/bin/env node
/** The command line: says its version at once, and loads the rest for everything else. */

import { VERSION } from '../engine/core/version';
import { ASSET_WORKER } from './batch/asset_worker';
import { optimizeLater } from './optimizing_compiler';

const words = process.argv.slice(2);
process.stdout.on('error', (error) => {
  void import('./program').then(({ endWithoutOutput }) => endWithoutOutput(error));
});
if (words.length === 1 && ['--version', '-v', 'version'].includes(words[0])) {
  process.stdout.write(`${VERSION}\n`);
} else if (words[0] === ASSET_WORKER) {
  optimizeLater();
  await import('./batch/worker');
} else {
  optimizeLater();
  const { startProgram } = await import('./program');
  await startProgram(words);
}
