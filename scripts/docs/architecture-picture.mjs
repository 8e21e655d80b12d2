// Draws docs/images/architecture.svg: the modules of scripts/structure/modules.mjs and their dependencies.
// Usage: node scripts/docs/architecture-picture.mjs

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from '../setup/environment.mjs';
import { modules } from '../structure/modules.mjs';

const box = { width: 104, height: 30, gap: 22, row: 64 };
const column = { width: 520, gap: 40, margin: 20, top: 70 };
const colours = {
  wasm: '#e8eef7',
  'web/engine': '#e9f5ec',
  'web/app': '#fbf1e2',
  'web/cli': '#fbf1e2',
  'web/service_worker': '#fbf1e2',
};

/**
 * The offset of a module from the middle of its row, in boxes, chosen so that no arrow runs behind another box. A row with a
 * module that is not listed here is spread evenly.
 */
const shift = {
  'wasm/base': 0,
  'wasm/mesh': -0.5,
  'wasm/linear': 0.5,
  'wasm/simulate': -1.5,
  'wasm/query': -0.5,
  'wasm/elastic': 0.5,
  'wasm/fields': 1.5,
  'wasm/simplify': -0.5,
  'wasm/transfer': -1,
  'wasm/modes': 0.5,
  'wasm/compare': -0.4,
  'wasm/fit': 0,
  'wasm/bind': 0.6,
  'web/app/worker': -1,
  'web/app/viewer': 0,
  'web/cli': 1,
  'web/app/state': -1,
  'web/app/controls': -0.25,
  'web/app/files': -1.25,
  'web/app/panels': -0.75,
  'web/app': -0.75,
};

/** Only modules that are folders are drawn. */
const drawn = Object.keys(modules).filter((module) => !/\.\w+$/.test(module));

const isCore = (module) => module.startsWith('wasm/');
const labelOf = (module) => (module === 'web/app' ? 'app' : module.split('/').at(-1));
const groupOf = (module) => (isCore(module) ? 'wasm' : module.split('/').slice(0, 2).join('/'));

/** Modules that `module` may use. The use of files of web/app by panels is ignored: those files assemble the panels. */
const knownBy = (module) =>
  modules[module].filter((target) => target !== 'web/app' && drawn.includes(target));

/** The length of the longest path down from a module; modules on one row do not use each other. */
const rankOf = (module) => Math.max(-1, ...knownBy(module).map(rankOf)) + 1;

const knows = (module, target) => knownBy(module).some((next) => next === target || knows(next, target));

/** Arrows that are not implied by a chain of other arrows. */
const plainArrows = drawn.flatMap((from) =>
  knownBy(from)
    .filter((to) => !knownBy(from).some((between) => between !== to && knows(between, to)))
    .map((to) => ({ from, to })),
);

/** Module -> { x, y } of the middle of its box; the core is on the left, everything else on the right. */
function positions() {
  const places = {};
  for (const side of [true, false]) {
    const own = drawn.filter((module) => isCore(module) === side);
    const left = column.margin + (side ? 0 : column.width + column.gap);
    for (const [rank, row] of groupByRank(own))
      row.forEach((module, i) => {
        const even = i - (row.length - 1) / 2;
        const offset = row.every((one) => one in shift) ? shift[module] : even;
        const x = left + column.width / 2 + offset * (box.width + box.gap);
        places[module] = { x, y: heightOf() - 60 - rank * box.row };
      });
  }
  return places;
}

function groupByRank(list) {
  const groups = new Map();
  for (const module of list) groups.set(rankOf(module), [...(groups.get(rankOf(module)) ?? []), module]);
  return groups;
}

const heightOf = () => column.top + 60 + Math.max(...drawn.map(rankOf)) * box.row;

function drawArrow({ from, to }, places) {
  const [start, end] = [places[from], places[to]];
  const [top, bottom] = [start.y + box.height / 2, end.y - box.height / 2 - 3];
  const bend = (bottom - top) / 2;
  const path = `M${start.x} ${top} C${start.x} ${top + bend} ${end.x} ${bottom - bend} ${end.x} ${bottom}`;
  return `<path d="${path}" marker-end="url(#tip)"/>`;
}

function drawModule(module, { x, y }) {
  const [left, top] = [x - box.width / 2, y - box.height / 2];
  return (
    `<rect x="${left}" y="${top}" width="${box.width}" height="${box.height}" rx="5" fill="${colours[groupOf(module)]}"/>` +
    `<text x="${x}" y="${y + 5}">${labelOf(module)}</text>`
  );
}

/** Draws how calls cross from the engine's `core` to the core's `bind`. */
function drawBoundary({ 'web/engine/core': from, 'wasm/bind': to }) {
  const [start, end] = [from.x - box.width / 2, to.x + box.width / 2 + 3];
  const middle = column.margin + column.width + column.gap / 2;
  return (
    `<path d="M${start} ${from.y} C${middle} ${from.y} ${middle} ${from.y} ${middle} ${from.y - box.row} V${to.y + box.row} C${middle} ${to.y} ${middle} ${to.y} ${end} ${to.y}" stroke-dasharray="5 4" marker-end="url(#tip)"/>` +
    `<text x="${(end + middle) / 2}" y="${to.y - 12}">the boundary: embind</text>`
  );
}

function drawTitle(text, left) {
  return `<text class="title" x="${left + column.width / 2}" y="34">${text}</text>`;
}

/** The picture as SVG text. */
export function drawArchitecture() {
  const places = positions();
  const width = 2 * (column.width + column.margin) + column.gap;
  const right = column.margin + column.width + column.gap;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${heightOf()}" font-family="sans-serif" font-size="14" text-anchor="middle">`,
    '<title>The modules of Limber; an arrow points to a module that its start may depend on</title>',
    '<style>path{fill:none;stroke:#8a94a3}rect{stroke:#5b6573}text{fill:#1c2530}.title{font-weight:bold}</style>',
    '<marker id="tip" markerWidth="7" markerHeight="7" refX="3" refY="3" orient="auto"><path d="M0 0L6 3L0 6" style="fill:none"/></marker>',
    `<rect width="${width}" height="${heightOf()}" fill="#fff" style="stroke:none"/>`,
    drawTitle('wasm: the core, C++', column.margin),
    drawTitle('web: engine (green), page and command line (sand), TypeScript', right),
    drawBoundary(places),
    ...plainArrows.map((arrow) => drawArrow(arrow, places)),
    ...Object.entries(places).map(([module, place]) => drawModule(module, place)),
    '</svg>',
    '',
  ].join('\n');
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  writeFileSync(join(root, 'docs', 'images', 'architecture.svg'), drawArchitecture());
  console.log('wrote docs/images/architecture.svg');
}
