// Writes docs/limber.1, the manual page of the command line, from the table of flags; a test checks that it is current.
//
//   node scripts/docs/man-page.mjs

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../setup/bundle.mjs';
import { root } from '../setup/environment.mjs';

const folder = mkdtempSync(join(tmpdir(), 'limber-man-'));
try {
  await bundleModule('web/cli/shell/man_page.ts', folder);
  const { manPage } = await import(pathToFileURL(join(folder, 'man_page.js')).href);
  writeFileSync(join(root, 'docs', 'limber.1'), manPage());
} finally {
  rmSync(folder, { recursive: true, force: true });
}
