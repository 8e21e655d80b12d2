// What a glTF file has besides the positions of its vertices, and what of it another file lacks.

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import validator from 'gltf-validator';
import { jsonOf } from './gltf_file.mjs';

/** These say how numbers are stored; a tool may store them otherwise. */
const STORAGE =
  /^(KHR_mesh_quantization|EXT_meshopt_compression|KHR_meshopt_compression|KHR_draco_mesh_compression)$/;

const namesOf = (list = []) =>
  list.map(({ name }) => name).filter((name) => name !== undefined && name !== '');

/** How many objects of the file have extras. */
function extrasIn(value) {
  if (value === null || typeof value !== 'object') return 0;
  const own =
    !Array.isArray(value) && value.extras !== undefined && Object.keys(value.extras).length > 0 ? 1 : 0;
  return Object.entries(value).reduce(
    (sum, [key, inner]) => sum + (key === 'extras' ? 0 : extrasIn(inner)),
    own,
  );
}

/** The extensions that objects of the file have; one that is listed and used nowhere is no loss. */
function extensionsIn(value, found = new Set()) {
  if (value === null || typeof value !== 'object') return found;
  for (const name of Object.keys(value.extensions ?? {})) found.add(name);
  for (const inner of Object.values(value)) extensionsIn(inner, found);
  return found;
}

/** Faces of all triangles as they are drawn: a mesh counts once for each node. */
function facesOf({ nodes = [], meshes = [], accessors = [] }) {
  const facesOfMesh = meshes.map(({ primitives }) =>
    primitives.reduce((sum, { mode = 4, indices, attributes }) => {
      const count = accessors[indices ?? attributes.POSITION]?.count ?? 0;
      return sum + (mode === 4 ? count / 3 : 0);
    }, 0),
  );
  return nodes.reduce((sum, { mesh }) => sum + (mesh === undefined ? 0 : facesOfMesh[mesh]), 0);
}

async function validatorErrors(path) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
    externalResourceFunction: async (uri) =>
      new Uint8Array(readFileSync(join(dirname(path), decodeURIComponent(uri)))),
  });
  return report.issues.numErrors;
}

/** Names and counts of everything in a file that a simplification has no reason to change. */
export async function inventoryOf(path) {
  const { json } = jsonOf(path);
  const { nodes = [], meshes = [], skins = [], animations = [], extensions = {} } = json;
  const primitives = meshes.flatMap((mesh) => mesh.primitives);
  const targets = meshes.reduce((sum, mesh) => sum + (mesh.primitives[0]?.targets?.length ?? 0), 0);
  return {
    faces: facesOf(json),
    errors: await validatorErrors(path),
    names: {
      scene: namesOf(json.scenes),
      node: namesOf(nodes),
      mesh: namesOf(meshes),
      material: namesOf(json.materials),
      animation: namesOf(animations),
      'morph target': meshes.flatMap(({ extras }) => extras?.targetNames ?? []),
      attribute: primitives.flatMap(({ attributes }) => Object.keys(attributes)),
      extension: [...extensionsIn(json)].filter((name) => !STORAGE.test(name)),
      variant: namesOf(extensions.KHR_materials_variants?.variants),
    },
    counts: {
      scenes: json.scenes?.length ?? 0,
      textures: json.textures?.length ?? 0,
      skins: skins.length,
      joints: skins.reduce((sum, { joints }) => sum + joints.length, 0),
      channels: animations.reduce((sum, { channels }) => sum + channels.length, 0),
      'morph targets': targets,
      cameras: json.cameras?.length ?? 0,
      lights: extensions.KHR_lights_punctual?.lights?.length ?? 0,
      'objects with extras': extrasIn(json),
    },
  };
}

/** What `after` lacks of `before`, as clauses. */
export function lossesOf(before, after) {
  const losses = [];
  for (const [kind, names] of Object.entries(before.names)) {
    const left = new Set(after.names[kind]);
    const gone = [...new Set(names)].filter((name) => !left.has(name));
    if (gone.length > 0)
      losses.push(
        `${kind} ${gone.slice(0, 3).join(', ')}${gone.length > 3 ? ` and ${gone.length - 3} more` : ''}`,
      );
  }
  for (const [kind, count] of Object.entries(before.counts))
    if (after.counts[kind] < count) losses.push(`${count - after.counts[kind]} of ${count} ${kind}`);
  return losses;
}
