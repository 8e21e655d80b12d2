// No file may include or import itself through others. A C++ header and its source count as one file.

import { importEdges } from './imports.mjs';
import { isCore } from './texts.mjs';

const unitOf = (path) => (isCore(path) ? path.replace(/\.(h|cpp)$/, '') : path);

/** Unit -> the units that it includes or imports. */
function unitGraph(files) {
  const graph = new Map(files.map(({ path }) => [unitOf(path), new Set()]));
  for (const { from, to } of importEdges(files))
    if (unitOf(from) !== unitOf(to) && graph.has(unitOf(to))) graph.get(unitOf(from)).add(unitOf(to));
  return graph;
}

/** Every unit that can be reached from `start`; `start` is among them only if it is on a cycle. */
function reachableFrom(start, graph) {
  const seen = new Set();
  const open = [start];
  while (open.length)
    for (const next of graph.get(open.pop()) ?? [])
      if (!seen.has(next)) {
        seen.add(next);
        open.push(next);
      }
  return seen;
}

/** Groups of units that reach all others of their group, as lists of names. */
export function cyclesOf(files) {
  const graph = unitGraph(files.filter(({ text }) => text));
  const reach = new Map([...graph.keys()].map((unit) => [unit, reachableFrom(unit, graph)]));
  const onCircle = [...graph.keys()].filter((unit) => reach.get(unit).has(unit));
  const groups = new Map();
  for (const unit of onCircle) {
    const group = onCircle.filter((other) => reach.get(unit).has(other) && reach.get(other).has(unit));
    groups.set(group[0], group);
  }
  return [...groups.values()];
}

/** One sentence for every cycle. */
export const importCycles = (files) =>
  cyclesOf(files).map((group) => `These ${group.length} include each other in a cycle: ${group.join(', ')}.`);
