// What a file shows: the triangles of its scene in one pose, with normals, texture coordinates and colours.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import sharp from 'sharp';

/** The model of a file, with its companions. */
export function openFile(engine, path) {
  const folder = dirname(path);
  const companions = path.endsWith('.gltf')
    ? readdirSync(folder, { recursive: true })
        .map(String)
        .filter((name) => /\.(bin|png|jpe?g)$/i.test(name))
    : [];
  const files = [basename(path), ...companions].filter((name) => existsSync(join(folder, name)));
  return engine.openModel(
    files.map((name) => ({ name, bytes: new Uint8Array(readFileSync(join(folder, name))) })),
  );
}

/** The textures of base colours as pixels: { width, height, data } with three bytes each. */
export async function texturesOf({ document }) {
  const textures = new Map();
  for (const material of document.getRoot().listMaterials()) {
    const texture = material.getBaseColorTexture();
    if (!texture?.getImage() || textures.has(texture)) continue;
    const { data, info } = await sharp(texture.getImage())
      .removeAlpha()
      .toColourspace('srgb')
      .raw()
      .toBuffer({ resolveWithObject: true });
    textures.set(texture, { data, width: info.width, height: info.height });
  }
  return textures;
}

/**
 * Lists of triangles, one for each primitive in each place. `pose`: the number of a pose of posesInAnimations; absent: at rest,
 * where skinned bodies stand as their skeleton does in the scene.
 */
export function shownTriangles(engine, model, textures, pose) {
  const root = model.document.getRoot();
  const meshes = root.listMeshes();
  const shown = [];
  for (const node of root.listNodes()) {
    const body = model.bodies.find(({ mesh }) => meshes[mesh] === node.getMesh());
    if (!body) continue;
    const posed = pose === undefined ? null : engine.posesInAnimations(model.document, body)[pose];
    const place = posed ? null : node.getWorldMatrix();
    body.spans.forEach((span, i) => {
      const last = 3 * (body.spans[i + 1]?.first ?? body.indices.length / 3);
      const corners = body.indices.subarray(3 * span.first, last);
      const primitive = node.getMesh().listPrimitives()[span.primitive];
      shown.push(trianglesOf(body, span, primitive, { corners, place, posed, textures }));
    });
  }
  return shown;
}

function trianglesOf(body, span, primitive, { corners, place, posed, textures }) {
  const material = primitive.getMaterial();
  const positions = new Float64Array(3 * corners.length);
  corners.forEach((v, i) => {
    const at = (posed ?? body.positions).subarray(3 * v, 3 * v + 3);
    positions.set(place ? moved(place, at, 1) : at, 3 * i);
  });
  const info = material?.getBaseColorTextureInfo();
  const values = (semantic) => {
    const accessor = primitive.getAttribute(semantic);
    return accessor && ((v) => accessor.getElement(v - span.firstVertex, []));
  };
  // Normals of a pose are those of its faces, for both files alike.
  const normalAt = posed ? null : values('NORMAL');
  const normals = new Float64Array(positions.length);
  for (let i = 0; i < corners.length; i += 3) {
    const flat = faceNormal(positions, 3 * i);
    for (let k = 0; k < 3; ++k)
      normals.set(normalAt ? moved(place, normalAt(corners[i + k]), 0) : flat, 3 * (i + k));
  }
  const [uvAt, colourAt] = [values(`TEXCOORD_${info?.getTexCoord() ?? 0}`), values('COLOR_0')];
  const transform = info?.getExtension('KHR_texture_transform');
  const [su, sv] = transform?.getScale() ?? [1, 1];
  const texture = material?.getBaseColorTexture() && textures.get(material.getBaseColorTexture());
  return {
    positions,
    normals,
    uv: texture && uvAt ? Array.from(corners, (v) => uvAt(v)).flatMap(([x, y]) => [su * x, sv * y]) : null,
    texture,
    colours: colourAt ? Array.from(corners, (v) => colourAt(v).slice(0, 3)).flat() : null,
    factor: material?.getBaseColorFactor().slice(0, 3) ?? [1, 1, 1],
    isDoubleSided: material?.getDoubleSided() ?? false,
  };
}

/** By a matrix of 16 numbers, column by column; w is 1 for points and 0 for directions, whose length is not kept. */
function moved(m, [x, y, z], w) {
  return [0, 1, 2].map((c) => m[c] * x + m[4 + c] * y + m[8 + c] * z + m[12 + c] * w);
}

function faceNormal(p, i) {
  const a = [0, 1, 2].map((c) => p[i + 3 + c] - p[i + c]);
  const b = [0, 1, 2].map((c) => p[i + 6 + c] - p[i + c]);
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
