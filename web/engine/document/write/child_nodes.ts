/** Child nodes that take over the mesh of their parent. */

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

/** Whether a node has another purpose than to show its mesh, which a child could not take over; morph weights it could. */
export function moreThanMesh(document: Document): (node: Node) => boolean {
  const root = document.getRoot();
  const channels = root.listAnimations().flatMap((animation) => animation.listChannels());
  const moving = channels.filter((channel) => channel.getTargetPath() !== 'weights');
  const parts = new Set([
    ...root.listSkins().flatMap((skin) => skin.listJoints()),
    ...moving.map((channel) => channel.getTargetNode()),
  ]);
  return (node) =>
    parts.has(node) ||
    node.getCamera() !== null ||
    node.listExtensions().length > 0 ||
    node.listChildren().length > 0;
}

/** Moves the mesh of a node, its skin, weights and instances to a new child of this name with the same transformation. */
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
