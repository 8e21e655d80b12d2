// Measures how well every method preserves the motion of every mesh; writes tables, plots and pictures.
// Usage: npm run build && node tests/bench/fidelity/evaluate.mjs [--write] [--all] ...
//   --write        puts tables, plots and pictures into docs/results.md
//   --all          includes the large meshes
//   --quick        for tuning: prints a few meshes at 25 % with our methods only, in a minute
//   --motion       only measures how far the results' motions deviate from those of their originals, at 25 %
//   --set KEY=VALUE      changes a setting of our methods (repeatable; web/engine/settings/table.ts), e.g. --set fit=off
//   --methods a,b  --meshes a,b  --ratios 0.5,0.25      which to run; the beginning of a mesh's name is enough

import { parseArgs } from 'node:util';
import { attributeErrors } from './attributes.mjs';
import { writeDocument } from './document.mjs';
import { loadEngine } from './load_engine.mjs';
import { loadMeshes } from './meshes.mjs';
import { BEST_PEER, meshoptimizerPeers } from './meshoptimizer_peers.mjs';
import { runMotions } from './motion.mjs';
import { motionTable, writeMotions } from './motion_document.mjs';
import { ourMethods, peerMethods } from './methods.mjs';
import { writePictures } from './pictures.mjs';
import { printQuickTable } from './quick.mjs';
import { runCases } from './run_cases.mjs';
import { readChanges } from './settings.mjs';
import { meansTable, targetTable } from './tables.mjs';

const { values: options } = parseArgs({
  options: {
    write: { type: 'boolean', default: false },
    motion: { type: 'boolean', default: false },
    quick: { type: 'boolean', default: false },
    all: { type: 'boolean', default: false },
    set: { type: 'string', multiple: true, default: [] },
    methods: { type: 'string' },
    meshes: { type: 'string' },
    ratios: { type: 'string' },
  },
});
const listOf = (text) => text?.split(',').map((part) => part.trim());
const missing = [];
const loaded = await loadEngine();
const changes = readChanges(loaded.engine, options.set);
const meshes = loadMeshes(loaded, {
  names: listOf(options.meshes),
  isWanted: ({ large, quick }) => (options.quick ? quick : options.all || !large),
  missing,
});
const wanted = listOf(options.methods);
const isChosen = ({ name }) => !wanted || wanted.includes(name);
const ours = ourMethods(loaded, changes);
if (options.quick) {
  const peers = (await meshoptimizerPeers(loaded)).filter(({ name }) => name === BEST_PEER);
  for (const ratio of listOf(options.ratios)?.map(Number) ?? [0.25]) {
    const peer = runCases(loaded, { meshes, methods: peers, ratios: [ratio] }, () => {});
    printQuickTable(loaded, { meshes, methods: ours.filter(isChosen), ratio, peer });
  }
} else if (options.motion) {
  const methods = [...ours, ...(await peerMethods(loaded, missing))].filter(isChosen);
  const motions = runMotions(loaded, { meshes, methods });
  console.log(`\n${motionTable(motions)}`);
  if (options.write) await writeMotions(motions);
} else {
  const ratios = listOf(options.ratios)?.map(Number) ?? [0.5, 0.25, 0.1];
  const methods = [...ours, ...(await peerMethods(loaded, missing))].filter(isChosen);
  const cases = runCases(loaded, { meshes, methods, ratios });
  for (const ratio of ratios) console.log(`\nAt ${100 * ratio} %\n\n${meansTable(cases, ratio)}`);
  console.log(`\n${targetTable(cases)}`);
  if (options.write) {
    await writePictures(cases, meshes, missing);
    const attributes = await attributeErrors(loaded, { methods: ours.filter(isChosen), ratios, missing });
    await writeDocument(cases, { meshes, methods, ratios, attributes, missing });
  }
}
if (missing.length) console.log(`\nMISSING HERE:\n${missing.map((what) => `- ${what}`).join('\n')}`);
process.exit(0); // the core's threads would keep Node alive
