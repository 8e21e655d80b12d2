/** Models of callers as files for the worker, and results in documents of callers. */

import { Document, Format, Logger, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { replaceBodies } from '../engine/document/export';
import { LimberError } from './options';
import type { Model } from './options';
import type { ModelFiles, OptimizeReply } from './protocol';

/** A document in memory is not compressed, whatever its file was. */
const COMPRESSED = /(draco|meshopt)/i;

/** Documents may come from another copy of glTF-Transform. */
export const isDocument = (model: Model): model is Document =>
  typeof (model as Partial<Document> | null)?.getRoot === 'function';

/** Throws LimberError where it is no model. */
export async function filesOf(model: Model): Promise<ModelFiles> {
  if (isDocument(model)) return filesOfDocument(model);
  if (model instanceof Uint8Array) return [{ name: 'model.glb', bytes: model }];
  if (model instanceof ArrayBuffer) return [{ name: 'model.glb', bytes: new Uint8Array(model) }];
  if (Array.isArray(model)) return [...(model as ModelFiles)];
  throw new LimberError(
    'There is no model: give a glTF-Transform Document, the bytes of a GLB, or files with name and bytes.',
  );
}

/** The document as a glTF with its buffers and images, exactly as it is in memory; extensions that are not known are left out. */
async function filesOfDocument(document: Document): Promise<ModelFiles> {
  const extensions = ALL_EXTENSIONS.filter(({ EXTENSION_NAME }) => !COMPRESSED.test(EXTENSION_NAME));
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(extensions);
  const { json, resources } = await io.writeJSON(document, { format: Format.GLTF, basename: 'document' });
  const text = new TextEncoder().encode(JSON.stringify(json));
  const companions = Object.entries(resources).map(([name, bytes]) => ({ name, bytes }));
  return [{ name: 'document.gltf', bytes: text }, ...companions];
}

/** Gives the meshes of the document the geometry of the bodies; null leaves one as it is. */
export function applyBodies(document: Document, bodies: OptimizeReply['bodies'], fields: boolean): void {
  const buffer = document.getRoot().listBuffers()[0] ?? document.createBuffer();
  // Meshes without normals stay without, as in every glTF.
  replaceBodies({ document, buffer }, bodies, { fields, smoothed: false });
}
