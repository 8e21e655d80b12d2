import { Document, NodeIO } from '@gltf-transform/core';
import { shade } from './normals';
import type { Sample } from './samples';
import type { Shape } from './shape';

/** A GLB with one mesh, one primitive and one plain material. The same shape gives the same bytes. */
export async function sampleGlb(sample: Sample, shape: Shape): Promise<Uint8Array> {
  const document = new Document();
  const root = document.getRoot();
  root.getAsset().generator = 'Limber';
  const buffer = document.createBuffer();
  const { positions, normals, triangles } = shade(shape, sample.creaseDegrees);
  const material = document
    .createMaterial(sample.name)
    .setBaseColorFactor([...sample.colour, 1])
    .setMetallicFactor(0)
    .setRoughnessFactor(sample.roughness)
    .setDoubleSided(sample.isOpen);
  const attribute = (name: string, values: Float32Array) =>
    document.createAccessor(name).setType('VEC3').setArray(values).setBuffer(buffer);
  const indices = positions.length / 3 <= 65535 ? Uint16Array.from(triangles) : triangles;
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', attribute('positions', positions))
    .setAttribute('NORMAL', attribute('normals', normals))
    .setIndices(document.createAccessor('triangles').setType('SCALAR').setArray(indices).setBuffer(buffer))
    .setMaterial(material);
  const mesh = document.createMesh(sample.name).addPrimitive(primitive);
  const node = document.createNode(sample.name).setMesh(mesh).setExtras({ about: sample.about });
  root.setDefaultScene(document.createScene(sample.name).addChild(node));
  return new NodeIO().writeBinary(document);
}
