// npm run site: builds the site in dist/site, which any host of static files can serve, from a folder of any name: the
// app, a gallery of results, and the documents. Fails if it contains a broken link.

import { cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from './build.mjs';
import { fail, root, run } from './setup/environment.mjs';
import { GALLERY, PUBLISHED, SECTIONS } from './site/contents.mjs';

const folder = join(root, 'dist', 'site');

function write(address, text) {
  const file = join(folder, address);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
}

function copy(from, to) {
  cpSync(join(root, from), join(folder, to), { recursive: true, filter: (path) => !path.endsWith('.md') });
}

/** The packages of these modules are there only after `build` has installed them. */
async function writePages() {
  const { documentPage } = await import('./site/documents.mjs');
  const { galleryPage, makeGallery } = await import('./site/gallery.mjs');
  const { homePage } = await import('./site/home.mjs');
  const { addressOf } = await import('./site/template.mjs');
  for (const { pages } of SECTIONS)
    for (const [document] of pages) write(addressOf(document), documentPage(document));
  write('index.html', homePage());
  console.log('Making the gallery ...');
  for (const { sample } of GALLERY) copy(`public/samples/${sample}.glb`, `gallery/models/${sample}.glb`);
  write('gallery/index.html', galleryPage(makeGallery(join(folder, 'gallery', 'models'))));
}

/** Makes the site from the build outputs; returns {pages, links, problems}: counts, and a line for every broken link. */
export async function makeSite() {
  console.log('Building the site ...');
  rmSync(folder, { recursive: true, force: true });
  const vite = join(root, 'node_modules', 'vite', 'bin', 'vite.js');
  run(process.execPath, [vite, 'build', '--logLevel', 'warn', '--config', 'vite.site.config.ts']);
  copy('dist/app', 'app');
  for (const path of PUBLISHED) copy(path, path);
  await writePages();
  const { checkLinks } = await import('./site/links.mjs');
  return checkLinks(folder);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  build();
  const { pages, links, problems } = await makeSite();
  if (problems.length > 0) fail(problems.join('\n'));
  console.log(`Built dist/site: ${pages} pages, ${links} links, all of which lead somewhere.`);
}
