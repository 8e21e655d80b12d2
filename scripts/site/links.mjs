// Checks every link, picture and anchor within a built site.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';

const unescape = (text) => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"');

function linksOf(html) {
  const found = html.matchAll(/\s(?:href|src|data-model)="([^"]*)"/g);
  return [...found].map(([, link]) => unescape(link));
}

/** The problem of one link of a page; null: none. `page`: its file, below `folder`. */
function problemOf(folder, page, link, anchorsOf) {
  if (/^(https?|mailto|data):/.test(link)) return null;
  const [path, fragment] = link.split('?')[0].split('#');
  const file = path === '' ? page : posix.normalize(posix.join(posix.dirname(page), decodeURI(path)));
  if (link === '' || link.startsWith('/') || file.startsWith('..') || !existsSync(join(folder, file)))
    return `${page}: ${link || 'an empty link'} leads nowhere`;
  if (fragment && file.endsWith('.html') && !anchorsOf(file).has(decodeURIComponent(fragment)))
    return `${page}: ${link} has no such heading`;
  return null;
}

/** {pages, links, problems} of all pages in a folder, except those of the app, which has tests of its own. */
export function checkLinks(folder) {
  const pages = readdirSync(folder, { recursive: true })
    .map((name) => name.replaceAll('\\', '/'))
    .filter((name) => name.endsWith('.html') && !name.startsWith('app/'));
  const anchors = new Map();
  const anchorsOf = (page) => {
    if (!anchors.has(page)) {
      const html = readFileSync(join(folder, page), 'utf8');
      anchors.set(page, new Set([...html.matchAll(/\sid="([^"]*)"/g)].map(([, id]) => unescape(id))));
    }
    return anchors.get(page);
  };
  const problems = [];
  let links = 0;
  for (const page of pages)
    for (const link of linksOf(readFileSync(join(folder, page), 'utf8'))) {
      links++;
      const problem = problemOf(folder, page, link, anchorsOf);
      if (problem) problems.push(problem);
    }
  return { pages: pages.length, links, problems };
}
