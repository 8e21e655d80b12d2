// Writes a module with short names and without spaces.
// Usage: node scripts/setup/minify.mjs FROM TO
// A separate program, because its dependencies are installed only after the scripts that call it have been loaded.

import { readFileSync, writeFileSync } from 'node:fs';
import { minifySync } from 'vite';

const [from, to] = process.argv.slice(2);
const { code, errors } = minifySync(from, readFileSync(from, 'utf8'), { module: true });
if (errors.length > 0) throw new Error(`${from} cannot be minified: ${errors[0].message}`);
writeFileSync(to, code);
