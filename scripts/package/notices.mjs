// The licences of third-party code in the package.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../setup/environment.mjs';

/** The names of the packages of modules. */
function packagesOf(modules) {
  const names = [...modules].map((id) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(id)?.[1]);
  return [...new Set(names.filter((name) => name !== undefined))].sort();
}

function licenceOf(name) {
  const folder = join(root, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  // Packages without a licence text name a licence whose text is next to this script.
  const shared = join(root, 'scripts', 'package', 'licences', `${license}.txt`);
  if (!file && !existsSync(shared)) throw new Error(`${name} has no text of its licence, ${license}.`);
  const text = readFileSync(file ? join(folder, file) : shared, 'utf8').trim();
  return `## ${name} ${version} (${license})\n\n${text}\n`;
}

/** The text of THIRD-PARTY-NOTICES.md. */
export function notices(modules) {
  const core = readFileSync(join(root, 'scripts', 'package', 'core_notices.md'), 'utf8');
  return [core, ...packagesOf(modules).map(licenceOf)].join('\n');
}
