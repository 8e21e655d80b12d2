/** Levels of detail inside one glTF: nodes by name, or the extension MSFT_lod. */

import type { Document, GLTF, Mesh, Node } from '@gltf-transform/core';
import type { LevelStyle } from '../../core/output_choices';
import { INSTANCING } from '../placements';
import { channelsOf, moreThanMesh, moveToChild } from './child_nodes';

const MSFT_LOD = 'MSFT_lod';
/** The height in pixels of the screen on which a level may differ from the original by one pixel. */
export const LINES = 1080;

/** The nodes that show the levels of one mesh, first level first. */
export interface LevelNodes {
  /** their numbers in the file */
  nodes: number[];
  /** the screen coverage, as a share of its height, down to which each is shown */
  coverage: number[];
}

/** The further levels of one mesh of the document. */
export interface MeshLevels {
  mesh: Mesh;
  /** from the second level on */
  further: Mesh[];
  /** largest distance of each further level from the original, % of the diagonal */
  deviations: number[];
}

/**
 * Puts further levels beside every node that shows one of the meshes. `nodes`: the node keeps its place and gets a child for each
 * level, NAME_LOD0 and so on, as Unity and Unreal look for them. `msft`: further levels stand in no scene; the node of the first
 * one names them.
 */
export function insertLevels(
  document: Document,
  meshes: MeshLevels[],
  style: Exclude<LevelStyle, 'files'>,
): LevelNodes[] {
  const root = document.getRoot();
  const inserted: LevelNodes[] = [];
  const isMore = moreThanMesh(document);
  for (const { mesh, further, deviations } of meshes)
    for (const node of root.listNodes().filter((one) => one.getMesh() === mesh)) {
      const first = style === 'nodes' || isMore(node) ? moveToChild(document, node) : node;
      const name = node.getName() || mesh.getName();
      if (first !== node || style === 'nodes') first.setName(`${name}_LOD0`);
      const others = further.map((own, i) => copyNode(document, first, own, `${name}_LOD${i + 1}`));
      if (style === 'nodes') for (const other of others) node.addChild(other);
      const nodes = [first, ...others].map((one) => root.listNodes().indexOf(one));
      if (style === 'msft') inserted.push({ nodes, coverage: coverageOf(deviations) });
    }
  return inserted;
}

/** A copy of a node with another mesh; animations of weights apply to it as well. */
function copyNode(document: Document, first: Node, mesh: Mesh, name: string): Node {
  const copy = document
    .createNode(name)
    .setMesh(mesh)
    .setSkin(first.getSkin())
    .setWeights(first.getWeights())
    .setTranslation(first.getTranslation())
    .setRotation(first.getRotation())
    .setScale(first.getScale());
  const instances = first.getExtension(INSTANCING);
  if (instances) copy.setExtension(INSTANCING, instances);
  for (const { animation, channel } of channelsOf(document, first))
    if (channel.getTargetPath() === 'weights') animation.addChannel(channel.clone().setTargetNode(copy));
  return copy;
}

/**
 * Per level the share of the picture's height from which on it is shown. `deviations`: of the further levels, % of the diagonal.
 * A level takes over where its distance from the original is one line of the picture. The diagonal of a mesh counts as its height;
 * the last level is shown down to nothing.
 */
export function coverageOf(deviations: number[]): number[] {
  let least = 1;
  const ends = deviations.map((deviation) => {
    least = Math.min(least, deviation > 0 ? 100 / (deviation * LINES) : 1);
    return least;
  });
  return [...ends, 0];
}

/** Writes the levels of MSFT_lod into the JSON, which it changes. */
export function addLevels(json: GLTF.IGLTF, levels: LevelNodes[]): void {
  if (levels.length === 0) return;
  for (const { nodes, coverage } of levels) {
    const [first, ...others] = nodes;
    const node = json.nodes![first];
    node.extensions = { ...node.extensions, [MSFT_LOD]: { ids: others } };
    node.extras = { ...(node.extras as object), MSFT_screencoverage: coverage };
  }
  json.extensionsUsed = [...new Set([...(json.extensionsUsed ?? []), MSFT_LOD])];
}
