// Writes the generated part of docs/results.md, between the markers, and its plots.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { wrapProse } from '../prose.mjs';
import { imageFolder, root } from './load_engine.mjs';
import { LEFT_OUT } from './meshes.mjs';
import { PICTURES, fileOf } from './pictures.mjs';
import { facesPlot, meshPlot } from './plots.mjs';
import { attributeTable, meansTable, meshTable, remarks, targetTable } from './tables.mjs';

const [BEGIN, END] = ['<!-- fidelity: begin -->', '<!-- fidelity: end -->'];
const percent = (ratio) => `${100 * ratio} %`;

const least = { best: Math.min };
const most = { best: Math.max };
const FREQUENCIES = { key: 'frequencyErrorMean', digits: 2, ...least };
/** The measures that are listed for every mesh at 25 %. */
const DETAILS = [
  ['Mean frequency error of modes 1-10, %', FREQUENCIES],
  ['Lowest subspace MAC of modes 1-10', { key: 'macMin', digits: 3, ...most }],
  ['Mean distance of the surfaces, % of the diagonal', { key: 'meanDistance', digits: 4, ...least }],
  ['Mean smallest angle, degrees', { key: 'meanMinAngle', digits: 1, ...most }],
];

function introduction({ meshes, methods, missing }) {
  const faces = meshes.map(({ name, faces: count }) => `${name} ${count.toLocaleString('en-US')}`);
  const versions = methods.flatMap(({ isOurs, version }) => (isOurs ? [] : [version]));
  const left = LEFT_OUT.map(([names, reason]) => `${names} (${reason})`);
  return [
    `Written by \`node tests/bench/fidelity/evaluate.mjs --write\` on ${cpus().length} x ${cpus()[0].model.trim()}, Node ${process.versions.node}.`,
    `Meshes and their faces: ${faces.join(', ')}. Left out: ${left.join('; ')}.`,
    `Peers: ${versions.join('; ')}.`,
    ...(missing.length ? [`Missing: ${missing.join('; ')}.`] : []),
  ].join('\n\n');
}

function sectionsOf(cases, ratios, attributes) {
  const found = remarks(cases);
  const others = ratios.filter((ratio) => ratio !== 0.25);
  return [
    '### Against the targets',
    'Means are over the meshes on which both methods reached the count; the meshes that miss a target are named.',
    targetTable(cases),
    '### At 25 % of the faces',
    '![Mean frequency error of every mesh by every method](images/simplification/frequencies.svg)',
    meansTable(cases, 0.25),
    ...DETAILS.flatMap(([title, options]) => [`#### ${title}`, meshTable(cases, 0.25, options)]),
    '### As pictures, at 25 %',
    ...PICTURES.map(({ mesh }) => `![${mesh} by every method](images/simplification/${fileOf(mesh)})`),
    '_Spot by Keenan Crane (public domain), the skirt from Codim-IPC (Apache-2.0)._',
    '### At other counts',
    '![Mean frequency error over the count of faces](images/simplification/faces.svg)',
    ...others.flatMap((ratio) => [
      `#### At ${percent(ratio)}`,
      meansTable(cases, ratio),
      `Mean frequency error of modes 1-10, %:`,
      meshTable(cases, ratio, FREQUENCIES),
    ]),
    '### Texture coordinates',
    'Only our methods, on textured files and with the whole pipeline: at every vertex of the original, the distance between the texture of the result and that of the original, as a length on the surface in % of the diagonal. If a seam has moved past a vertex, the vertex counts in the last column and not in the mean.',
    attributeTable(attributes),
    ...(found.length ? ['### Results that miss the count or change the topology', found.join('\n')] : []),
  ];
}

/** Replaces the text between the markers and writes the plots. */
export async function writeDocument(cases, { meshes, methods, ratios, attributes, missing }) {
  const path = join(root, 'docs', 'results.md');
  const before = readFileSync(path, 'utf8');
  if (!before.includes(BEGIN) || !before.includes(END))
    throw new Error(`${path} has no place for the tables: add "${BEGIN}" and "${END}".`);
  const content = [
    BEGIN,
    introduction({ meshes, methods, missing }),
    ...sectionsOf(cases, ratios, attributes),
    END,
  ];
  const after = `${before.split(BEGIN)[0]}${wrapProse(content.join('\n\n'))}${before.split(END)[1]}`;
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  mkdirSync(imageFolder, { recursive: true });
  writeFileSync(join(imageFolder, 'frequencies.svg'), meshPlot(cases, 0.25));
  writeFileSync(join(imageFolder, 'faces.svg'), facesPlot(cases));
  console.log('wrote docs/results.md and its plots');
}
