/** The only glTF reader and writer, with its decoders. */

import { Logger, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';

const MESHOPT = 'EXT_meshopt_compression';
const DRACO = 'KHR_draco_mesh_compression';

export const SUPPORTED_EXTENSIONS = new Set<string>(
  ALL_EXTENSIONS.map(({ EXTENSION_NAME }) => EXTENSION_NAME),
);

/** Reads and writes in memory only. Loads the decoders of `extensions`, the extensions that a file uses. */
export async function createGltfIo(extensions: readonly string[] = []): Promise<WebIO> {
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  if (extensions.includes(MESHOPT)) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder');
    await MeshoptDecoder.ready;
    io.registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  }
  if (extensions.includes(DRACO)) io.registerDependencies({ 'draco3d.decoder': await loadDraco() });
  return io;
}

/** In Node the decoder finds its wasm file in its own folder; a bundle ships that file and passes its address. */
async function loadDraco(): Promise<unknown> {
  const { default: createDecoder } = await import('draco3dgltf/draco_decoder_gltf_nodejs.js');
  if (import.meta.env.SSR) return createDecoder();
  const { default: address } = await import('draco3dgltf/draco_decoder_gltf.wasm?url');
  return createDecoder({ locateFile: () => address });
}
