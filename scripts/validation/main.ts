/** Runs all cases and returns the files to write: path below docs/ -> content. */

import { loadCore } from '../../web/engine/core/load_core';
import { barCases } from './cases/bars';
import { plateCases } from './cases/plates';
import { slabCase } from './cases/slab';
import { sphereCase } from './cases/sphere';
import { tubeCases } from './cases/tubes';
import { hasPlot, page } from './page';
import { convergencePlot } from './plot';

export async function validate(
  wasmFolder: string,
  report: (line: string) => void,
): Promise<Map<string, string>> {
  const core = await loadCore({ threads: 2, wasmFolder });
  const groups = [plateCases, barCases, tubeCases, (c: typeof core) => [sphereCase(c), slabCase(c)]];
  const results = groups.flatMap((cases) => {
    const found = cases(core);
    for (const { title, runs } of found) report(`${title}: ${runs.length} meshes`);
    return found;
  });
  const files = new Map([['validation.md', page(results)]]);
  for (const result of results.filter(hasPlot))
    files.set(`images/validation/${result.id}.svg`, convergencePlot(result));
  return files;
}
