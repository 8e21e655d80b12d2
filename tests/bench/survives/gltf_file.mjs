// Files of glTF as JSON and bytes: read, written, and one that uses much of the format.

import { readFileSync, writeFileSync } from 'node:fs';

const [GLTF, JSON_CHUNK, BIN_CHUNK] = [0x46546c67, 0x4e4f534a, 0x004e4942];

/** { json, bin } of a GLB, and of a glTF its JSON alone. */
export function jsonOf(path) {
  const bytes = readFileSync(path);
  if (bytes.length < 20 || bytes.readUInt32LE(0) !== GLTF)
    return { json: JSON.parse(bytes.toString('utf8')), bin: null };
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString('utf8'));
  return { json, bin: bytes.subarray(20 + length + 8) };
}

export function writeGlb(path, { json, bin }) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 0x20)]);
  const head = Buffer.alloc(20);
  [GLTF, 2, 20 + padded.length + 8 + bin.length, padded.length, JSON_CHUNK].forEach((word, i) =>
    head.writeUInt32LE(word, 4 * i),
  );
  const binHead = Buffer.alloc(8);
  binHead.writeUInt32LE(bin.length, 0);
  binHead.writeUInt32LE(BIN_CHUNK, 4);
  writeFileSync(path, Buffer.concat([head, padded, binHead, bin]));
}

/** Appends numbers to the binary part and returns the index of a new accessor over them. */
function addAccessor({ json, bin }, values, type, width) {
  const data = Buffer.from(Float32Array.from(values).buffer);
  json.bufferViews.push({ buffer: 0, byteOffset: bin.length, byteLength: data.length });
  const columns = Array.from({ length: width }, (_, i) => values.filter((_, k) => k % width === i));
  json.accessors.push({
    bufferView: json.bufferViews.length - 1,
    componentType: 5126,
    count: values.length / width,
    type,
    min: columns.map((column) => Math.min(...column)),
    max: columns.map((column) => Math.max(...column)),
  });
  return { accessor: json.accessors.length - 1, bin: Buffer.concat([bin, data]) };
}

/** The file with two scenes, a camera, a light, variants, extras, a vendor's extension and an animation of nodes. */
export function withEverything({ json, bin }) {
  const nodes = json.nodes.length;
  json.nodes.push(
    { name: 'eye', camera: 0, translation: [0, 1, 3] },
    { name: 'lamp', extensions: { KHR_lights_punctual: { light: 0 } }, translation: [0, 2, 0] },
    { name: 'marker', extras: { spawn: true } },
    { name: 'tagged', extensions: { VENDOR_tag: { tag: 'door' } } },
  );
  json.scenes[0].nodes.push(nodes, nodes + 1, nodes + 2, nodes + 3);
  json.scenes.push({ name: 'second', nodes: [nodes + 2], extras: { of: 'the second scene' } });
  json.cameras = [{ name: 'eye', type: 'perspective', perspective: { yfov: 0.8, znear: 0.1 } }];
  json.materials ??= [];
  json.materials.push({
    name: 'red',
    pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] },
    extras: { id: 7 },
  });
  json.materials.push({ name: 'blue', pbrMetallicRoughness: { baseColorFactor: [0, 0, 1, 1] } });
  const [red, blue] = [json.materials.length - 2, json.materials.length - 1];
  json.meshes[0].extras = { collider: 'box' };
  for (const primitive of json.meshes[0].primitives) {
    primitive.material = red;
    primitive.extensions = { KHR_materials_variants: { mappings: [{ material: blue, variants: [0] }] } };
  }
  json.extensions = {
    KHR_lights_punctual: { lights: [{ name: 'lamp', type: 'point', intensity: 20 }] },
    KHR_materials_variants: { variants: [{ name: 'winter' }] },
  };
  json.extensionsUsed = ['KHR_lights_punctual', 'KHR_materials_variants', 'VENDOR_tag'];
  const times = addAccessor({ json, bin }, [0, 1, 2], 'SCALAR', 1);
  const places = addAccessor({ json, bin: times.bin }, [0, 1, 3, 0, 2, 3, 0, 1, 3], 'VEC3', 3);
  json.animations = [
    {
      name: 'fly',
      channels: [{ sampler: 0, target: { node: nodes, path: 'translation' } }],
      samplers: [{ input: times.accessor, output: places.accessor }],
    },
  ];
  json.buffers[0].byteLength = places.bin.length;
  return { json, bin: places.bin };
}
