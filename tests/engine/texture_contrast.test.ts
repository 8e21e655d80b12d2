import type { Document, Material } from '@gltf-transform/core';
import { KHRMaterialsClearcoat, KHRTextureTransform } from '@gltf-transform/extensions';
import sharp from 'sharp';
import { describe, expect, it } from 'vitest';
import type { TriangleMesh } from '../../web/engine/core/core';
import { costAttributesOf } from '../../web/engine/body/cost_attributes';
import { MAX_PIXELS } from '../../web/engine/document/textures/pixels';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { prepareBody } from '../../web/engine/stages/prepared';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { pngOf } from './support/pictures';
import { optimized, runOfModel } from './support/runs';
import { grid } from './support/shapes';

const core = await loadTestCore(1);
const SIZE = 64;
const [BLACK, WHITE] = [
  [0, 0, 0],
  [255, 255, 255],
];

type Colour = (x: number, y: number) => number[];
const flat: Colour = () => [200, 90, 20];
const checker: Colour = (x, y) => ((Math.floor(x / 4) + Math.floor(y / 4)) % 2 ? BLACK : WHITE);
/** Flat where u < 0.5. */
const halfFlat: Colour = (x, y) => (2 * x < SIZE ? WHITE : checker(x, y));

const picture = (colour: Colour, size = SIZE) =>
  pngOf(Array.from({ length: size }, (_, y) => Array.from({ length: size }, (_, x) => colour(x, y))));

/** A sheet whose texture coordinates are its x and y, bent by `bend`. */
function sheetOf(
  image: Uint8Array,
  change: (material: Material, document: Document) => void = () => {},
  bend: (x: number, y: number) => number = () => 0,
) {
  const source = startDocument();
  const mesh: TriangleMesh = grid(24, 24);
  const uv = Array.from({ length: mesh.positions.length / 3 }, (_, v) => {
    const [x, y] = mesh.positions.subarray(3 * v, 3 * v + 2);
    return [x + bend(x, y), y];
  }).flat();
  const texture = source
    .createTexture()
    .setImage(image as Uint8Array<ArrayBuffer>)
    .setMimeType('image/png');
  const material = source.createMaterial().setBaseColorTexture(texture);
  change(material, source);
  addMesh(source, 'sheet', [
    primitiveOf(source, mesh)
      .setAttribute('TEXCOORD_0', floats(source, 'VEC2', uv))
      .setMaterial(material),
  ]);
  return source;
}

function setJpeg(material: Material) {
  material.getBaseColorTexture()!.setMimeType('image/jpeg');
}

async function prepared(source: Document) {
  const model = await openModel([await glbFile(source)]);
  return { model, body: prepareBody(core, model.bodies[0], defaultSettings(), model.document) };
}

/** The means of the weights left and right of x = 0.5 but for what lies near it; null where all are 1 by default. */
async function weightsOf(source: Document) {
  const { model, body } = await prepared(source);
  const weights = costAttributesOf(model.document, body)!.textureWeights;
  if (weights.length === 0) return null;
  const mean = (isInside: (x: number) => boolean) => {
    const chosen = [...weights].filter((_, t) =>
      isInside(body.mesh.positions[3 * body.mesh.triangles[3 * t]]),
    );
    return chosen.reduce((sum, weight) => sum + weight, 0) / chosen.length;
  };
  return [mean((x) => x < 0.35), mean((x) => x > 0.65)];
}

describe('the weights of texture coordinates', () => {
  it('are 0 on a texture of one colour', async () => {
    expect(await weightsOf(sheetOf(picture(flat)))).toEqual([0, 0]);
  });

  it('are 1 on black and white squares, and where the texture is flat by parts only there', async () => {
    for (const weight of (await weightsOf(sheetOf(picture(checker))))!) expect(weight).toBeGreaterThan(0.5);
    const [left, right] = (await weightsOf(sheetOf(picture(halfFlat))))!;
    expect(left).toBe(0);
    expect(right).toBeGreaterThan(0.5);
  });

  it('are the square of the slope on a ramp from black to white, per twentieth of the diagonal', async () => {
    const ramp: Colour = (x) => [0, 1, 2].map(() => Math.round((255 * x) / (SIZE - 1)));
    const step = 0.05 * Math.SQRT2;
    // The spread of positions is that along the ramp and that across it.
    for (const weight of (await weightsOf(sheetOf(picture(ramp))))!)
      expect(weight / ((step * step) / 2)).toBeCloseTo(1, 0);
  });

  it('are the same for a JPEG as for a PNG', async () => {
    const jpeg = async (colour: Colour) => sharp(picture(colour)).jpeg({ quality: 100 }).toBuffer();
    const [left, right] = (await weightsOf(sheetOf(await jpeg(halfFlat), setJpeg)))!;
    expect(left).toBeLessThan(0.001);
    expect(right).toBeGreaterThan(0.5);
    expect(await weightsOf(sheetOf((await jpeg(halfFlat)).subarray(0, 60), setJpeg))).toBeNull();
  });

  it('include alpha if it cuts the surface out', async () => {
    const cut = picture((x, y) => [9, 9, 9, checker(x, y)[0]]);
    expect(await weightsOf(sheetOf(cut))).toEqual([0, 0]);
    for (const weight of (await weightsOf(sheetOf(cut, (material) => material.setAlphaMode('MASK'))))!)
      expect(weight).toBeGreaterThan(0.5);
  });

  it('include the other textures of a material, with their transforms', async () => {
    const normals = (material: Material, document: Document) =>
      material.setNormalTexture(
        document
          .createTexture()
          .setImage(picture(halfFlat) as Uint8Array<ArrayBuffer>)
          .setMimeType('image/png'),
      );
    const [left, right] = (await weightsOf(sheetOf(picture(flat), normals)))!;
    expect([left, right > 0.5]).toEqual([0, true]);
    const moved = (material: Material, document: Document) => {
      const transform = document.createExtension(KHRTextureTransform).createTransform();
      material
        .getBaseColorTextureInfo()!
        .setExtension('KHR_texture_transform', transform.setScale([0.4, 1]).setOffset([1, 0]));
    };
    expect(await weightsOf(sheetOf(picture(halfFlat), moved))).toEqual([0, 0]);
  });

  it('are 1 if a picture cannot be decoded', async () => {
    const good = picture(flat);
    const broken = good.slice(0, 60);
    const wrong = good.map((byte, i) => (i > 40 ? byte ^ 85 : byte));
    const large = picture(flat, 2);
    new DataView(large.buffer).setUint32(16, MAX_PIXELS);
    for (const image of [broken, wrong, large, new Uint8Array([1, 2, 3])])
      expect(await weightsOf(sheetOf(image))).toBeNull();
    const foreign = (material: Material, document: Document) => {
      const coat = document.createExtension(KHRMaterialsClearcoat).createClearcoat();
      material.setExtension(
        'KHR_materials_clearcoat',
        coat.setClearcoatTexture(material.getBaseColorTexture()),
      );
    };
    expect(await weightsOf(sheetOf(good, foreign))).toBeNull();
  });

  it('decode small pictures of a file before a large one that would use up the budget', async () => {
    const large = picture(flat);
    new DataView(large.buffer).setUint32(16, 1024);
    new DataView(large.buffer).setUint32(20, MAX_PIXELS / 1024);
    const small = (material: Material, document: Document) => {
      material.setOcclusionTexture(material.getBaseColorTexture());
      material.getOcclusionTextureInfo()!.setTexCoord(1);
      const image = picture(flat) as Uint8Array<ArrayBuffer>;
      material.setBaseColorTexture(document.createTexture().setImage(image).setMimeType('image/png'));
    };
    expect(await weightsOf(sheetOf(large, small))).toEqual([0, 0]);
  });

  it('let a sheet collapse where its texture is flat and keep it where it is not', async () => {
    const bend = (x: number, y: number) => 0.03 * Math.sin(25 * x) * Math.sin(25 * y);
    const shareOfRight = async (colour: Colour) => {
      const { model, body } = await prepared(sheetOf(picture(colour), undefined, bend));
      const settings = { ...defaultSettings(), maxDeviation: 0, fit: 'off' as const };
      const { result } = optimized(runOfModel(core, model, 0), settings, body.mesh.triangles.length / 12);
      const { positions } = result.mesh;
      const right = positions.filter((value, i) => i % 3 === 0 && value > 0.5).length;
      return right / (positions.length / 3);
    };
    expect(await shareOfRight(halfFlat)).toBeGreaterThan((await shareOfRight(checker)) + 0.1);
  });
});
