/**
 * Compiles the shader programs for a first file while nothing is shown: an emulated graphics card takes tenths of a
 * second for each kind of material.
 */

import type { Pane } from '../pane';
import type { ShownFiles } from './shown_files';

const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];
const NORMALS = [0, 0, 1, 0, 0, 1, 0, 0, 1];
const [JSON_CHUNK, BINARY_CHUNK] = [0x4e4f534a, 0x004e4942];

/**
 * `pane`: that of the original; `draw` draws the stage. The drawing is removed before the browser shows it. Does
 * nothing once there is a file.
 */
export async function warmUp(files: ShownFiles, pane: Pane, draw: () => void): Promise<void> {
  await files.warmUp(warmFile(), () => {
    if (pane.mesh || pane.isLate) return;
    pane.show({ positions: Float32Array.from(TRIANGLE), triangles: Uint32Array.of(0, 1, 2) });
    files.moved();
    draw();
    pane.show(null);
  });
  if (!pane.mesh) draw();
}

/** A binary glTF of two triangles, with and without normals, drawn like a model without materials of its own. */
function warmFile(): Uint8Array {
  const data = new Uint8Array(Float32Array.from([...TRIANGLE, ...NORMALS]).buffer);
  const size = data.length / 2;
  const accessor = { componentType: 5126, type: 'VEC3', count: 3 };
  const document = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 } }, { attributes: { POSITION: 0 } }] }],
    accessors: [
      { ...accessor, bufferView: 0, min: [0, 0, 0], max: [1, 1, 0] },
      { ...accessor, bufferView: 1 },
    ],
    bufferViews: [0, size].map((byteOffset) => ({ buffer: 0, byteOffset, byteLength: size })),
    buffers: [{ byteLength: data.length }],
  };
  const text = JSON.stringify(document);
  const json = new TextEncoder().encode(text.padEnd(4 * Math.ceil(text.length / 4)));
  const words = (...values: number[]) => new Uint8Array(Uint32Array.from(values).buffer);
  const chunks = [...[words(json.length, JSON_CHUNK), json], ...[words(data.length, BINARY_CHUNK), data]];
  const length = 12 + chunks.reduce((sum, chunk) => sum + chunk.length, 0);
  return Uint8Array.from([words(0x46546c67, 2, length), ...chunks].flatMap((chunk) => [...chunk]));
}
