// The frame of every page of the site.

import { posix } from 'node:path';
import { SECTIONS } from './contents.mjs';

const SIGNS = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
export const escape = (text) => String(text).replace(/[&<>"]/g, (sign) => SIGNS[sign]);

/** The address of a document of the repository within the site. */
export const addressOf = (document) =>
  document
    .replace(/README\.md$/, 'guide.md')
    .replace(/\.md$/, '.html')
    .toLowerCase();

/** The relative path from one file of the site to another. */
export const way = (from, to) => posix.relative(posix.dirname(from), to);

function sideBar(address) {
  const link = ([document, name]) => {
    const target = addressOf(document);
    const current = target === address ? ' aria-current="page"' : '';
    return `<li><a href="${way(address, target)}"${current}>${escape(name)}</a></li>`;
  };
  const section = ({ name, pages }) => `<h2>${escape(name)}</h2><ul>${pages.map(link).join('')}</ul>`;
  return `<nav class="side" aria-label="Documents">${SECTIONS.map(section).join('')}</nav>`;
}

function topBar(address) {
  const links = [
    ['gallery/index.html', 'Gallery'],
    ['guide.html', 'Guide'],
    ['docs/engines.html', 'Engines'],
    ['docs/evidence.html', 'Evidence'],
  ];
  const link = ([target, name]) => `<a href="${way(address, target)}">${name}</a>`;
  const icon = way(address, 'app/icon.svg');
  const home = `<a class="home" href="${way(address, 'index.html')}"><img src="${icon}" alt="" width="26" height="26">Limber</a>`;
  const app = `<a class="button" href="${way(address, 'app/index.html')}">Open the app</a>`;
  return `<header class="top">${home}<nav aria-label="Site">${links.map(link).join('')}</nav>${app}</header>`;
}

/**
 * A whole page. `address`: its file within the site; `main`: its content as HTML; `script`: a file of `assets`;
 * `hasSideBar`: whether it has a side bar with the documents.
 */
export function pageOf({ address, title, main, script = null, hasSideBar = false }) {
  const asset = (name) => way(address, `assets/${name}`);
  const scripts = script ? `<script type="module" src="${asset(script)}"></script>` : '';
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escape(title)}</title>
<meta name="description" content="Meshes with few triangles that still bend right.">
<link rel="icon" href="${way(address, 'app/icon.svg')}">
<link rel="stylesheet" href="${asset('site.css')}">
${scripts}
</head>
<body class="${hasSideBar ? 'with-side' : 'plain'}">
<a class="skip" href="#main">Skip to the content</a>
${topBar(address)}
${hasSideBar ? sideBar(address) : ''}
<main id="main">
${main}
</main>
</body>
</html>
`;
}
