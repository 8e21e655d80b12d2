import { expect, it } from 'vitest';
import { attributesOf } from '../../web/engine/body/attributes';
import { DistinctMembers, extendHash } from '../../web/engine/core/distinct_members';
import { NONE } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { geometryOf } from '../../web/engine/document/vertices';
import { ownSources } from '../../web/engine/body/attributes';
import { inspectBody } from '../../web/engine/stages/prepared';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, startDocument } from './support/gltf';
import { processorTime } from './support/processor_time';

it('members of long groups are found like those of short ones, with few comparisons', () => {
  const values: number[] = [];
  const members = new DistinctMembers((one) => extendHash(0, values[one]));
  let looks = 0;
  const find = (group: number, value: number) => {
    const isSame = (one: number) => ++looks > 0 && values[one] === value;
    return members.find(group, isSame, () => extendHash(0, value));
  };
  for (let value = 0; value < 20_000; ++value) {
    expect(find(value % 2, value)).toBe(NONE);
    values.push(value);
    expect(members.add(value % 2)).toBe(value);
  }
  for (const value of [0, 1, 77, 19_999]) expect(find(value % 2, value)).toBe(value);
  expect([find(1, 0), find(0, -0)]).toEqual([NONE, 0]);
  expect(looks).toBeLessThan(30_000);
});

/** A fan whose corners are vertices of their own with texture coordinates of their own, but for every tenth face. */
async function fan(faces: number) {
  const angle = (i: number) => (2 * Math.PI * (i % faces)) / faces;
  const corners = Array.from({ length: faces }, (_, i) => [
    [0, 0, 0],
    ...[i, i + 1].map((at) => [Math.cos(angle(at)), Math.sin(angle(at)), 0]),
  ]);
  const uvs = corners.flatMap((_, i) => [0, 1, 2].flatMap((c) => [i % 10 === 0 ? 0 : i / faces, c / 2]));
  const document = startDocument();
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', floats(document, 'VEC3', corners.flat(2)))
    .setAttribute('TEXCOORD_0', floats(document, 'VEC2', uvs));
  addMesh(document, 'fan', [primitive]);
  return openModel([await glbFile(document)]);
}

it('a fan of many faces is classified and written in a time that grows with its faces', async () => {
  const core = await loadTestCore(1);
  const work = async (faces: number) => {
    const model = await fan(faces);
    const [body] = model.bodies;
    const { weld } = inspectBody(core, body, { weld: 0 });
    const seconds = processorTime();
    const { wedgeCount } = attributesOf(model.document, body, weld);
    const [primitive] = model.document.getRoot().listMeshes()[0].listPrimitives();
    const sourced = { mesh: weld.mesh, body, sources: ownSources(weld.mesh) };
    const all = Uint32Array.from({ length: faces }, (_, t) => t);
    const { vertexOfMesh } = geometryOf(sourced, body.spans[0], primitive, all, () => NONE);
    return { wedgeCount, written: vertexOfMesh.length, seconds: seconds() };
  };
  const small = await work(100);
  // At the centre one corner of its own for each face, but one for all of each tenth; on the rim two for each face.
  expect([small.wedgeCount, small.written]).toEqual([91 + 200, 91 + 200]);
  const large = await work(16_000);
  expect([large.wedgeCount, large.written]).toEqual([14_401 + 32_000, 14_401 + 32_000]);
  expect(large.seconds).toBeLessThan(3);
});
