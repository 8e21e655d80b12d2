#!/usr/bin/env node
/** The command line: says its version at once, and loads the rest for everything else. */

import { VERSION } from '../engine/core/version';

const words = process.argv.slice(2);
if (words.length === 1 && ['--version', '-v', 'version'].includes(words[0])) {
  process.stdout.write(`${VERSION}\n`);
} else {
  const { startProgram } = await import('./program');
  await startProgram(words);
}
