/** A model in which nothing is replaced. */

import type { GLTF } from '@gltf-transform/core';
import { GENERATOR } from '../export';
import { glbParts, isGlb, withJson } from '../glb';
import type { OpenModel, SourceFile } from '../model';
import { exportFiles } from './export_files';
import type { OutputForm } from './output_form';

/**
 * The files of a model in which nothing is replaced. A GLB of a GLB that needs no other file has its bytes but for the name of the
 * program that wrote it; other files are written anew.
 */
export async function passThrough(
  model: OpenModel,
  bytes: Uint8Array,
  { name, form }: { name: string; form: OutputForm },
): Promise<SourceFile[]> {
  const needsOthers = model.document
    .getRoot()
    .listBuffers()
    .some((buffer) => buffer.getURI() !== '');
  // The bytes of a packed model are those of its archive.
  const isWhole = isGlb(bytes) && !needsOthers;
  if (!isWhole || form.format !== 'glb' || form.isZipped) {
    const manner = { compression: 'like-input', style: 'files', keepsOrder: true } as const;
    return exportFiles(model, [], { name, form, manner, fields: false });
  }
  const json = JSON.parse(new TextDecoder().decode(glbParts({ name: model.name, bytes }).json)) as GLTF.IGLTF;
  json.asset.generator = GENERATOR;
  return [{ name, bytes: withJson(bytes, json) }];
}
