/** The only glTF reader and writer, with its decoders and encoders. */

import { Logger, WebIO } from '@gltf-transform/core';
import type { Document } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { withMeshBoxes } from './write/draco_boxes';
import type { DracoEncoder } from './write/draco_boxes';

export const MESHOPT = 'EXT_meshopt_compression';
/** The ratified name of the same format; files that use it are read and written through the other one. */
export const RATIFIED_MESHOPT = 'KHR_meshopt_compression';
export const DRACO = 'KHR_draco_mesh_compression';

export const SUPPORTED_EXTENSIONS = new Set<string>([
  ...ALL_EXTENSIONS.map(({ EXTENSION_NAME }) => EXTENSION_NAME),
  RATIFIED_MESHOPT,
]);

/** The logger of every document that is read or made, and of its copies: only Limber's own messages go to the console. */
export const SILENT = new Logger(Logger.Verbosity.SILENT);

const plainIo = (): WebIO => new WebIO().setLogger(SILENT).registerExtensions(ALL_EXTENSIONS);

/** Reads and writes in memory only. Loads the decoders of `extensions`, the extensions that a file uses. */
export async function createGltfIo(extensions: readonly string[] = []): Promise<WebIO> {
  const io = plainIo();
  if (extensions.includes(MESHOPT)) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder');
    await MeshoptDecoder.ready;
    io.registerDependencies({ 'meshopt.decoder': MeshoptDecoder });
  }
  if (extensions.includes(DRACO)) io.registerDependencies({ 'draco3d.decoder': await loadDracoDecoder() });
  return io;
}

/** A writer with the encoders of the extensions that the document uses. `keepsCorners`: see `packedInOrder`. */
export async function createGltfWriter(document: Document, keepsCorners = false): Promise<WebIO> {
  const io = plainIo();
  const names = document
    .getRoot()
    .listExtensionsUsed()
    .map(({ extensionName }) => extensionName);
  if (names.includes(MESHOPT)) {
    const encoder = await loadMeshoptEncoder();
    io.registerDependencies({ 'meshopt.encoder': keepsCorners ? packedInOrder(encoder) : encoder });
  }
  if (names.includes(DRACO))
    io.registerDependencies({ 'draco3d.encoder': withMeshBoxes(await loadDracoEncoder(), document) });
  return io;
}

type MeshoptEncoder = Awaited<ReturnType<typeof loadMeshoptEncoder>>;

/** meshopt's modes for index lists: in triangles the corners may come back rotated, other lists come back unchanged. */
export const [TRIANGLES_MODE, INDICES_MODE] = ['TRIANGLES', 'INDICES'];

/** An encoder that packs triangles in the mode of index sequences. The mode in the JSON has to be changed to match. */
const packedInOrder = (encoder: MeshoptEncoder): MeshoptEncoder => ({
  ...encoder,
  encodeGltfBuffer: (source, count, size, ...[mode, ...others]) =>
    encoder.encodeGltfBuffer(source, count, size, mode === TRIANGLES_MODE ? INDICES_MODE : mode, ...others),
});

export async function loadMeshoptEncoder() {
  const { MeshoptEncoder } = await import('meshoptimizer/encoder');
  await MeshoptEncoder.ready;
  return MeshoptEncoder;
}

/** In Node the decoder finds its wasm file in its own folder; a bundle ships that file and passes its address. */
async function loadDracoDecoder(): Promise<unknown> {
  const { default: createDecoder } = await import('draco3dgltf/draco_decoder_gltf_nodejs.js');
  if (import.meta.env.SSR) return createDecoder();
  const { default: address } = await import('draco3dgltf/draco_decoder_gltf.wasm?url');
  return createDecoder({ locateFile: () => address });
}

async function loadDracoEncoder(): Promise<DracoEncoder> {
  const { default: createEncoder } = await import('draco3dgltf/draco_encoder_gltf_nodejs.js');
  if (import.meta.env.SSR) return createEncoder();
  const { default: address } = await import('draco3dgltf/draco_encoder.wasm?url');
  return createEncoder({ locateFile: () => address });
}
