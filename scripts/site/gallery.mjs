// The results of the gallery, made with the ordinary command line, and the page that shows them.

import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { root, run } from '../setup/environment.mjs';
import { GALLERY } from './contents.mjs';
import { escape, pageOf } from './template.mjs';

const LIMBER = join(root, 'dist', 'cli', 'limber.mjs');
const readJson = (file) => JSON.parse(readFileSync(file, 'utf8'));

/** Optimizes and simulates a sample in `folder`; returns the data that the page shows. */
function makeEntry({ sample, optimize, simulate }, about, folder) {
  const [original, result, motion] = ['', '-coarse', '-motion'].map((end) => `${sample}${end}.glb`);
  const limber = (words, ...more) => {
    const report = join(folder, 'report.json');
    const args = [LIMBER, ...words, ...more, '--report', report, '--quiet', '--force'];
    run(process.execPath, args, { cwd: folder, quiet: true });
    return readJson(report);
  };
  const commands = [
    ['optimize', original, result, ...optimize],
    ['simulate', original, result, ...simulate],
  ];
  const optimized = limber(commands[0], '--soft');
  const simulated = limber(commands[1], '--seconds', '1.5', '--record', motion);
  rmSync(join(folder, 'report.json'));
  return { sample, original, result, motion, about, commands, optimized, simulated };
}

/** Makes all results in a folder that contains the samples. */
export function makeGallery(folder) {
  mkdirSync(folder, { recursive: true });
  const samples = readJson(join(root, 'public', 'samples', 'index.json'));
  return GALLERY.map((entry) =>
    makeEntry(
      entry,
      samples.find(({ id }) => id === entry.sample),
      folder,
    ),
  );
}

const percent = (value) => `${value < 0.01 ? '< 0.01' : value.toFixed(2)} %`;
const count = (value) => value.toLocaleString('en');

function numbersOf({ optimized, simulated }) {
  const { input, output, surface } = optimized;
  const { scenario, deviation } = simulated.simulation;
  const rows = [
    ['Faces', `${count(input.faces)} → ${count(output.faces)}`],
    ['Distance of the surfaces, mean', `${percent(surface.mean)} of the size`],
    ['Distance of the surfaces, largest', `${percent(surface.hausdorff)} of the size`],
    [`Distance in motion (${scenario}), mean`, `${percent(deviation.mean)} of the size`],
  ];
  return rows.map(([name, value]) => `<dt>${escape(name)}</dt><dd>${escape(value)}</dd>`).join('');
}

function canvas(file, caption) {
  const label = `${caption}: drag or use the arrow keys to turn it`;
  return `<figure><canvas data-model="models/${file}" tabindex="0" role="img" aria-label="${escape(label)}"></canvas><figcaption>${escape(caption)}</figcaption></figure>`;
}

function article(entry) {
  const { about, commands, sample, simulated } = entry;
  const { faces } = entry.optimized.output;
  const lines = commands.map((words) => `limber ${words.join(' ')}`).join('\n');
  return `<article class="result">
<h2>${escape(about.name)}</h2>
<p>${escape(about.about)}</p>
<div class="pictures">
<div class="turning">${canvas(entry.original, `Original, ${count(about.faces)} faces`)}${canvas(entry.result, `Limber, ${count(faces)} faces`)}</div>
<div class="turning">${canvas(entry.motion, `Both in motion: ${simulated.simulation.scenario}`)}</div>
</div>
<dl>${numbersOf(entry)}</dl>
<pre tabindex="0"><code>${escape(lines)}</code></pre>
<p><a href="../app/index.html?sample=${sample}">Open it in the app</a></p>
</article>`;
}

export function galleryPage(entries) {
  return pageOf({
    address: 'gallery/index.html',
    title: 'Gallery: Limber',
    script: 'gallery.js',
    main: `<div class="wide">
<h1>Gallery</h1>
<p class="lead">The samples of the app, as the command line leaves them. Drag a model to turn it. What moves was simulated for both
meshes alike, from the same start; the commands below each make the same again.</p>
<div class="controls">
<label>Look <select id="look"><option value="clay">Clay</option><option value="textured">Own materials</option><option value="matcap">Matcap</option></select></label>
<label><input type="checkbox" id="wires" checked> Edges</label>
<label><input type="checkbox" id="playing"> Motion</label>
</div>
<p id="trouble" role="status"></p>
${entries.map(article).join('\n')}
</div>`,
  });
}
