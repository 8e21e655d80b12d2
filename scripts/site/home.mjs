// The first page of the site.

import { pageOf } from './template.mjs';

const FOR_WHOM = [
  [
    'Artists',
    'Drop a model on the page, choose the motion that matters by eye, and take half of its triangles away. Nothing is uploaded.',
    'app/index.html',
    'Open the app',
  ],
  [
    'Engine programmers',
    'Jolt, MuJoCo, Newton and Blender: the numbers to type in so that the coarse mesh moves as the fine one did.',
    'docs/engines.html',
    'In your engine',
  ],
  [
    'Pipelines',
    'The command line, an npm package and batches, for one asset or for thousands, with reports in JSON.',
    'docs/batch.html',
    'Batches',
  ],
  [
    'Researchers',
    'The paper, equation by equation; other methods beside it; every number by one command.',
    'docs/evidence.html',
    'Evidence',
  ],
];

const card = ([name, text, target, link]) =>
  `<section><h2>${name}</h2><p>${text}</p><p><a href="${target}">${link}</a></p></section>`;

export function homePage() {
  return pageOf({
    address: 'index.html',
    title: 'Limber: meshes with few triangles that still bend right',
    main: `<div class="wide home">
<h1>Meshes with few triangles that still bend right</h1>
<p class="lead">Limber predicts how a soft body or a piece of cloth will bend, measures where it strains, and collapses edges so that
motion and shape survive. Then it finds the numbers for your engine, so that the coarse mesh moves as the fine one did.</p>
<p class="actions"><a class="button" href="app/index.html">Open the app</a> <a href="gallery/index.html">See results that turn</a> <a href="guide.html">Read the guide</a></p>
<figure><img src="docs/images/reduce.png" alt="The app: a sculpture beside its version with half of the faces" width="1280" height="800"></figure>
<div class="cards">${FOR_WHOM.map(card).join('')}</div>
<figure><img src="docs/images/engines/blender.png" alt="A cloth of 3,200 faces falls and swings in Blender; below it a quarter of its faces, as another tool leaves it and as Limber tunes it" loading="lazy">
<figcaption>A cloth falls and swings in Blender. Above: 3,200 faces. Below: a quarter of them, as another tool leaves it and as Limber
tunes it, with grey where the original is. <a href="docs/engines.html">In which engines and motions this holds, and where it does not.</a></figcaption></figure>
<h2>On your computer</h2>
<pre tabindex="0"><code>npm start    # sets up what is missing, builds, serves the app and prints its address
npm test     # the same, and runs the suites</code></pre>
</div>`,
  });
}
