// Documents of the repository as pages of the site.

import { existsSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import GithubSlugger from 'github-slugger';
import MarkdownIt from 'markdown-it';
import anchor from 'markdown-it-anchor';
import { root } from '../setup/environment.mjs';
import { PUBLISHED, SECTIONS } from './contents.mjs';
import { addressOf, escape, pageOf, way } from './template.mjs';

const DOCUMENTS = new Set(SECTIONS.flatMap(({ pages }) => pages.map(([document]) => document)));
const isPublished = (path) =>
  existsSync(join(root, path)) && PUBLISHED.some((start) => path === start || path.startsWith(`${start}/`));

/** The target of a link of a document within the site; null: the site does not have the target. */
function targetOf(link, document) {
  if (/^[a-z]+:/i.test(link) || link.startsWith('#')) return link;
  const [path, fragment] = link.split('#');
  const file = posix.normalize(posix.join(posix.dirname(document), path));
  if (!DOCUMENTS.has(file) && !isPublished(file)) return null;
  const target = DOCUMENTS.has(file) ? addressOf(file) : file;
  return way(addressOf(document), target) + (fragment ? `#${fragment}` : '');
}

/** Rewrites links and pictures; of a link to a source file only the text is kept. */
function rewriteLinks(tokens, document) {
  for (const { children } of tokens.filter(({ type }) => type === 'inline')) {
    const open = [];
    for (const token of children) {
      if (token.type === 'image') token.attrSet('src', targetOf(token.attrGet('src'), document) ?? '');
      if (token.type === 'link_open') {
        const target = targetOf(token.attrGet('href'), document);
        open.push(target !== null);
        if (target === null) token.hidden = true;
        else token.attrSet('href', target);
      }
      if (token.type === 'link_close' && !open.pop()) token.hidden = true;
    }
  }
}

/** An empty corner cell of a table is not a heading. */
function mendCorners(tokens) {
  tokens.forEach((token, i) => {
    if (token.type !== 'th_open' || tokens[i + 1].content !== '') return;
    token.tag = 'td';
    tokens[i + 2].tag = 'td';
  });
}

/** One document as a whole page. */
export function documentPage(document) {
  const slugger = new GithubSlugger();
  const markdown = new MarkdownIt({ html: true }).use(anchor, {
    slugify: (text) => slugger.slug(text),
    tabIndex: false,
  });
  // Tables may be wider than the window.
  markdown.renderer.rules.table_open = () =>
    '<div class="table" tabindex="0" role="group" aria-label="Table"><table>\n';
  markdown.renderer.rules.table_close = () => '</table></div>\n';
  for (const name of ['fence', 'code_block'])
    markdown.renderer.rules[name] = (tokens, i) =>
      `<pre tabindex="0"><code>${escape(tokens[i].content)}</code></pre>\n`;
  for (const name of ['link_open', 'link_close'])
    markdown.renderer.rules[name] = (tokens, i, options, _, self) =>
      tokens[i].hidden ? '' : self.renderToken(tokens, i, options);
  const tokens = markdown.parse(readFileSync(join(root, document), 'utf8'), {});
  rewriteLinks(tokens, document);
  mendCorners(tokens);
  const heading = tokens.findIndex(({ type, tag }) => type === 'heading_open' && tag === 'h1');
  const title = tokens[heading + 1].content.replaceAll('`', '');
  return pageOf({
    address: addressOf(document),
    title: title === 'Limber' ? 'Guide: Limber' : `${title}: Limber`,
    main: `<article class="document">${markdown.renderer.render(tokens, markdown.options, {})}</article>`,
    hasSideBar: true,
  });
}
