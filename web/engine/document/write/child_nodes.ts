/** Nodes that take over the mesh of another one at the same place. */

import type { Animation, AnimationChannel, Document, Node } from '@gltf-transform/core';
import { INSTANCING } from '../placements';

/** The channels of animations that move a node or its weights. */
export const channelsOf = (
  document: Document,
  node: Node,
): { animation: Animation; channel: AnimationChannel }[] =>
  document
    .getRoot()
    .listAnimations()
    .flatMap((animation) => animation.listChannels().map((channel) => ({ animation, channel })))
    .filter(({ channel }) => channel.getTargetNode() === node);

/** Gives the mesh of a node, its skin, its weights and its instances to a child of this name at the same place. */
export function moveToChild(document: Document, node: Node, name = ''): Node {
  const child = document
    .createNode(name)
    .setMesh(node.getMesh())
    .setSkin(node.getSkin())
    .setWeights(node.getWeights());
  const instances = node.getExtension(INSTANCING);
  if (instances) {
    child.setExtension(INSTANCING, instances);
    node.setExtension(INSTANCING, null);
  }
  node.setMesh(null).setSkin(null).setWeights([]).addChild(child);
  for (const { channel } of channelsOf(document, node))
    if (channel.getTargetPath() === 'weights') channel.setTargetNode(child);
  return child;
}
