// Writes THIRD_PARTY.md, which lists what ships of others, from the lock file; a test checks that it is current.
//
//   node scripts/docs/third-party.mjs

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from '../setup/environment.mjs';

/** What each package that is named in package.json is there for. */
const USES = {
  '@fontsource-variable/inter': 'the typeface of the page',
  '@gltf-transform/core': 'glTF documents',
  '@gltf-transform/extensions': 'extensions of glTF',
  '@gltf-transform/functions': 'compression of glTF',
  '@preact/signals': 'state of the page',
  'camera-controls': 'camera of the page',
  comlink: 'calls between the page and its workers',
  'd3-scale-chromatic': 'colour maps',
  draco3dgltf: 'Draco compression',
  earcut: 'triangulation of polygons',
  fflate: 'ZIP archives',
  gifenc: 'GIFs of the page',
  'gltf-validator': 'the Khronos validator of glTF',
  'jpeg-js': 'pixels of JPEG textures',
  meshoptimizer: 'meshopt compression, and the simplifier that results are compared with',
  preact: 'elements of the page',
  three: 'drawing, the loader of pictures of glTF, and MikkTSpace',
  'three-mesh-bvh': 'picking vertices',
};

const TOOLS = {
  '@axe-core/playwright': 'tests of accessibility',
  '@playwright/test': 'tests of the page in Chromium',
  acorn: 'checks of scripts',
  eslint: 'lint',
  'fast-check': 'property-based tests and fuzzing',
  'github-slugger': 'anchors of headings on the site',
  'jolt-physics': 'tests of the loader of Jolt',
  'markdown-it': 'documents as pages of the site',
  'markdown-it-anchor': 'anchors of headings on the site',
  prettier: 'formatting',
  typescript: 'types',
  'typescript-eslint': 'lint',
  vite: 'bundling',
  vitest: 'tests',
  '@vitest/coverage-v8': 'coverage of tests',
};

const table = (head, rows) =>
  [head, head.map(() => '---'), ...rows].map((row) => `| ${row.join(' | ')} |`).join('\n');

const quoted = (name) => `\`${name}\``;

/** Throws an Error where a package has no words on what it is for. */
function useOf(uses, name) {
  if (!uses[name]) throw new Error(`scripts/docs/third-party.mjs does not say what ${name} is for.`);
  return uses[name];
}

function unformatted() {
  const read = (name) => JSON.parse(readFileSync(join(root, name), 'utf8'));
  const { dependencies, devDependencies } = read('package.json');
  const { packages } = read('package-lock.json');
  const entry = (name) => packages[`node_modules/${name}`];
  const row = (uses) => (name) => [quoted(name), entry(name).version, entry(name).license, useOf(uses, name)];
  const shipped = Object.keys(dependencies);
  const indirect = Object.keys(packages)
    .filter((path) => path !== '' && !packages[path].dev && !packages[path].optional)
    .map((path) => path.replace('node_modules/', ''))
    .filter((name) => !shipped.includes(name));
  const tools = Object.keys(devDependencies).filter((name) => !name.startsWith('@types/'));
  return `# Third-party software

Written by \`node scripts/docs/third-party.mjs\` from the lock file. \`npm run pack\` puts the full texts of the licences of what the npm
package contains into its THIRD-PARTY-NOTICES.md. A check (\`node scripts/check.mjs --only licences\`) refuses licences that are not
permissive and not MPL.

## In the WebAssembly core

${table(
  ['work', 'licence', 'use'],
  [
    ['[Eigen](https://gitlab.com/libeigen/eigen)', 'MPL-2.0', 'linear algebra, unmodified'],
    ['[Spectra](https://github.com/yixuan/spectra)', 'MPL-2.0', 'eigenvalues of sparse matrices, unmodified'],
    [
      '[Emscripten](https://github.com/emscripten-core/emscripten), musl, libc++ and compiler-rt',
      'MIT; Apache-2.0 with LLVM exceptions',
      'the runtime of the core and the scripts that load it',
    ],
  ],
)}

## In the page, the command line and the library

${table(['package', 'version', 'licence', 'use'], shipped.map(row(USES)))}

What these need in turn. Bundles contain only what is called; of sharp, which only decodes pictures, they have nothing:

${table(
  ['package', 'version', 'licence'],
  indirect.map((name) => [quoted(name), entry(name).version, entry(name).license]),
)}

## Tools, which do not ship

${table(['package', 'version', 'licence', 'use'], tools.map(row(TOOLS)))}

GoogleTest (BSD-3-Clause) tests the core. Benchmarks also call SciPy, scikit-sparse, pymeshlab, fast-simplification, MuJoCo, Newton and
Blender, where they are installed; none of them is needed to build or to run Limber.
`;
}

/** The text of THIRD_PARTY.md. */
export async function thirdParty() {
  const { format } = await import('prettier');
  const options = JSON.parse(readFileSync(join(root, '.prettierrc.json'), 'utf8'));
  return format(unformatted(), { parser: 'markdown', ...options });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  writeFileSync(join(root, 'THIRD_PARTY.md'), await thirdParty());
