/** Small glTF scenes for the tests. */

import { Document, WebIO } from '@gltf-transform/core';
import type { Buffer, Mesh } from '@gltf-transform/core';

/** An open tube of 1 x 1 x `length` along z, of `rings` rings of 4 `side` quads. */
function tube(
  document: Document,
  buffer: Buffer,
  { length, rings, side }: { length: number; rings: number; side: number },
): Mesh {
  const around = 4 * side;
  const positions: number[] = [];
  const uv: number[] = [];
  const triangles: number[] = [];
  for (let ring = 0; ring <= rings; ring++)
    for (let i = 0; i < around; i++) {
      const angle = (2 * Math.PI * i) / around;
      positions.push(Math.cos(angle) / 2, Math.sin(angle) / 2, (length * ring) / rings);
      uv.push(i / around, ring / rings);
    }
  const at = (ring: number, i: number) => ring * around + (i % around);
  for (let ring = 0; ring < rings; ring++)
    for (let i = 0; i < around; i++) {
      const [a, b, c, d] = [at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)];
      triangles.push(a, b, c, a, c, d);
    }
  const accessor = (type: 'VEC2' | 'VEC3', values: number[]) =>
    document.createAccessor('', buffer).setType(type).setArray(new Float32Array(values));
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', positions))
    .setAttribute('TEXCOORD_0', accessor('VEC2', uv))
    .setIndices(document.createAccessor('', buffer).setType('SCALAR').setArray(new Uint16Array(triangles)));
  return document.createMesh().addPrimitive(primitive);
}

/**
 * Two tubes that stand side by side: "red" of 1,280 faces and "blue" of 640. Their meshes lie along z, and their nodes turn z up, as
 * exporters of programs with z up write it. The red one slides along x in an animation of one second.
 */
export async function standingTubes(): Promise<Uint8Array> {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  const colours = { red: [0.8, 0.03, 0.03, 1], blue: [0.03, 0.05, 0.8, 1] } as const;
  const nodes = Object.entries(colours).map(([name, colour], i) => {
    const mesh = tube(document, buffer, { length: 4, rings: i === 0 ? 40 : 20, side: 4 }).setName(name);
    const material = document
      .createMaterial(name)
      .setBaseColorFactor([...colour])
      .setRoughnessFactor(0.9)
      .setMetallicFactor(0)
      .setDoubleSided(true);
    mesh.listPrimitives()[0].setMaterial(material);
    const node = document.createNode(name).setMesh(mesh);
    // -90 degrees about x.
    node.setRotation([-Math.SQRT1_2, 0, 0, Math.SQRT1_2]).setTranslation([3 * i, 0, 0]);
    scene.addChild(node);
    return node;
  });
  const input = document
    .createAccessor('', buffer)
    .setType('SCALAR')
    .setArray(new Float32Array([0, 1]));
  const output = document
    .createAccessor('', buffer)
    .setType('VEC3')
    .setArray(new Float32Array([0, 0, 0, -3, 0, 0]));
  const sampler = document.createAnimationSampler().setInput(input).setOutput(output);
  const channel = document.createAnimationChannel().setTargetNode(nodes[0]).setTargetPath('translation');
  document
    .createAnimation('slide')
    .addSampler(sampler.setInterpolation('LINEAR'))
    .addChannel(channel.setSampler(sampler));
  return new WebIO().writeBinary(document);
}
