// Writes docs/validation.md and its plots, which compare computed with analytic frequencies.
// Usage: npm run build && npm run validate        takes about two minutes

import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { format, resolveConfig } from 'prettier';
import { bundleModule } from '../setup/bundle.mjs';
import { root } from '../setup/environment.mjs';

const outDir = join(root, 'build', 'validation');
await bundleModule('scripts/validation/main.ts', outDir);
const { validate } = await import(pathToFileURL(join(outDir, 'main.js')).href);
const wasmFolder = pathToFileURL(join(root, 'public', 'wasm', '/')).href;
const files = await validate(wasmFolder, (line) => console.log(line));
for (const [name, content] of files) {
  const path = join(root, 'docs', name);
  mkdirSync(dirname(path), { recursive: true });
  const isPage = name.endsWith('.md');
  const options = { ...(await resolveConfig(path)), filepath: path };
  writeFileSync(path, isPage ? await format(content, options) : content);
  console.log(`wrote docs/${name}`);
}
process.exit(0); // the core's threads would keep Node alive
