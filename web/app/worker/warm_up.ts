/** Runs the engine once on a small body while it is idle, so that the browser has compiled it before the first file. */

import type { Core, TriangleMesh } from '../../engine/core/core';
import { openModel } from '../../engine/document/open';
import { defaultSettings } from '../../engine/settings/options';
import { FileRun } from '../../engine/stages/file_run';
import { STAGES } from '../../engine/stages/stages';
import { drawOriginal } from './exporting';
import { strainOverview } from './strain_overview';

/** Quads of the body around and across: enough calls for functions to be compiled with optimization. */
const AROUND = 40;
const ACROSS = 24;

/**
 * Browsers first compile WebAssembly quickly, and then optimize frequently called functions, which would otherwise take
 * half a second of the first file (https://v8.dev/blog/wasm-dynamic-tiering). Ends before its next step once `isWanted`
 * returns false. Errors are not reported: the first file will report them.
 */
export async function warmUp(core: Core, isWanted: () => boolean): Promise<void> {
  let file: FileRun | null = null;
  try {
    file = new FileRun(core, await openModel([{ name: 'torus.obj', bytes: torus() }]));
    for (const step of stepsOf(file)) {
      // Lets calls run that have arrived meanwhile.
      await new Promise((resolve) => setTimeout(resolve));
      if (!isWanted()) return;
      await step();
    }
  } catch {
    // see above
  } finally {
    file?.dispose();
  }
}

function stepsOf(file: FileRun): (() => unknown)[] {
  const settings = { ...defaultSettings(), targetFaces: AROUND * ACROSS };
  const [run] = file.runs;
  if (!run) return [];
  const mesh = (): TriangleMesh => run.get(STAGES.prepared, settings).mesh;
  return [
    () => run.get(STAGES.modes, settings),
    () => run.get(STAGES.history, settings),
    () => run.get(STAGES.measured, settings),
    () => strainOverview(file.core, mesh(), run.get(STAGES.modes, settings)),
    () => drawOriginal(file),
  ];
}

/** An OBJ file. */
function torus(): Uint8Array {
  const lines: string[] = [];
  const vertex = (i: number, k: number): number => (i % AROUND) * ACROSS + (k % ACROSS) + 1;
  for (let i = 0; i < AROUND; i++)
    for (let k = 0; k < ACROSS; k++) {
      const [a, b] = [(2 * Math.PI * i) / AROUND, (2 * Math.PI * k) / ACROSS];
      const radius = 1 + 0.4 * Math.cos(b);
      lines.push(`v ${radius * Math.cos(a)} ${radius * Math.sin(a)} ${0.4 * Math.sin(b)}`);
      lines.push(`f ${vertex(i, k)} ${vertex(i + 1, k)} ${vertex(i + 1, k + 1)} ${vertex(i, k + 1)}`);
    }
  return new TextEncoder().encode(lines.join('\n'));
}
