import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { MATERIAL_NAMES, MATERIALS, materialNameOf } from '../../web/engine/settings/materials';
import { checkSettings, defaultSettings } from '../../web/engine/settings/options';
import { findPins } from '../../web/engine/body/pins';
import { parsePins } from '../../web/engine/settings/pin_text';
import { modesCall } from '../../web/engine/stages/modes';
import { prepareBody } from '../../web/engine/stages/prepared';
import { loadTestCore } from './support/core';
import { textFile } from './support/files';
import { addMesh, floats, glbFile, primitiveOf, startDocument } from './support/gltf';
import { grid, toObj, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A sheet of 6 x 2 cells over [0, 1]^2 in a file whose first vertex is used by no face. */
async function sheet() {
  const text = `v 9 9 9\n${toObj(grid(6, 2)).replace(/^f (\d+) (\d+) (\d+)$/gm, (_, a, b, c) => `f ${+a + 1} ${+b + 1} ${+c + 1}`)}`;
  const model = await openModel([textFile('sheet.obj', text)]);
  return { document: model.document, prepared: prepareBody(core, model.bodies[0], defaultSettings()) };
}

const pinsOf = async (text: string) => {
  const { document, prepared } = await sheet();
  return [...findPins(text, document, prepared)];
};

describe('pins', () => {
  it('are empty for an empty text', async () => {
    expect(parsePins('')).toEqual([]);
    expect(await pinsOf('')).toEqual([]);
  });

  it('are parsed once per setting', () => {
    const terms = parsePins('low:6+vertices:1,2');
    expect(parsePins('high:6', 'lock')).toEqual([{ kind: 'high', percent: 6 }]);
    expect(parsePins('low:6+vertices:1,2')).toBe(terms);
    expect(parsePins('low:7')).not.toBe(terms);
  });

  it('select the ends of the longest axis', async () => {
    expect(await pinsOf('low:0')).toEqual([0, 7, 14]);
    expect(await pinsOf('high:20')).toEqual([5, 6, 12, 13, 19, 20]);
  });

  it('select the vertices in a box, whose corners may come in any order', async () => {
    expect(await pinsOf('box:0.9,-1,-1,2,0.1,1')).toEqual([6]);
    expect(await pinsOf('box:2,0.1,1,0.9,-1,-1')).toEqual([6]);
  });

  it('select vertices by their number in the file, and join terms', async () => {
    const { document, prepared } = await sheet();
    const first = prepared.weld.vertexOfSource.findIndex((vertex) => vertex === 0);
    expect([...findPins(`vertices:${first}+high:0`, document, prepared)]).toEqual([0, 6, 13, 20]);
  });

  it('select vertices of any primitive whose attribute is above one half', async () => {
    const document = startDocument();
    const [one, two] = [primitiveOf(document, grid(1, 1)), primitiveOf(document, torus())];
    const values = new Float32Array(288).fill(0);
    values[5] = 1;
    values[6] = 0.4;
    two.setAttribute('_PIN', floats(document, 'SCALAR', values));
    addMesh(document, 'both', [one, two]);
    const model = await openModel([await glbFile(document)]);
    const prepared = prepareBody(core, model.bodies[0], defaultSettings());
    const [vertex] = findPins('attribute:_PIN', model.document, prepared);
    expect([...findPins('attribute:_PIN', model.document, prepared)]).toHaveLength(1);
    expect([...prepared.mesh.positions.slice(3 * vertex, 3 * vertex + 3)]).toEqual([
      ...torus().positions.slice(15, 18),
    ]);
    expect(() => findPins('attribute:_NO', model.document, prepared)).toThrow(
      '“Held in place” names the attribute _NO, but "both" has POSITION, _PIN: name one of these.',
    );
  });

  it('select nothing in a body without the attribute that another body has', async () => {
    const document = startDocument();
    const held = primitiveOf(document, grid(1, 1));
    held.setAttribute('_PIN', floats(document, 'SCALAR', new Float32Array(4).fill(1)));
    addMesh(document, 'held', [held]);
    addMesh(document, 'loose', [primitiveOf(document, torus())]);
    const model = await openModel([await glbFile(document)]);
    const [first, second] = model.bodies.map((body) => prepareBody(core, body, defaultSettings()));
    expect([...findPins('attribute:_PIN', model.document, first)]).toEqual([0, 1, 2, 3]);
    expect([...findPins('attribute:_PIN', model.document, second)]).toEqual([]);
    expect(() => findPins('attribute:_NO', model.document, second)).toThrow(
      '“Held in place” names the attribute _NO, but "loose" has POSITION: name one of these.',
    );
  });

  it.each(['low', 'low:', 'low:x', 'low:1,2', 'box:1,2,3', 'vertices:', 'top:5'])(
    '"%s" is refused with the forms',
    (text) => {
      expect(() => checkSettings({ ...defaultSettings(), pins: text })).toThrow(
        /^“Held in place” has ".*": give low:PCT, high:PCT, box:.*, attribute:NAME or vertices:i,j, joined by \+\.$/,
      );
    },
  );

  it.each([
    ['low:200', 'a percentage from 0 to 100'],
    ['high:-1', 'a percentage from 0 to 100'],
    ['vertices:1.5', 'numbers of vertices, which are whole and begin at 0'],
    ['vertices:0,-1', 'numbers of vertices, which are whole and begin at 0'],
  ])('"%s" is refused with the range', (text, range) => {
    const message = `“Held in place” has "${text}": give ${range}.`;
    expect(() => checkSettings({ ...defaultSettings(), pins: `low:5+${text}` })).toThrow(message);
  });

  it('may have blanks around the + that joins them', () => {
    expect(parsePins('low:5 + high:6')).toEqual(parsePins('low:5+high:6'));
  });

  it.each(['low:5+', '+low:5', 'low:5++high:5', '+'])('"%s" is refused for its empty term', (text) => {
    expect(() => checkSettings({ ...defaultSettings(), pins: text })).toThrow(
      '“Held in place” has a + that does not join two terms: remove it, or give low:PCT, ',
    );
  });

  it('refuse a vertex that the body does not have', async () => {
    await expect(pinsOf('vertices:400')).rejects.toThrow(
      /^“Held in place” names vertex 400, but "sheet" has only \d+: name one below that\.$/,
    );
  });

  it('leave one rigid motion if they are on a line, and none otherwise', async () => {
    const { document, prepared } = await sheet();
    const settings = { ...defaultSettings(), model: 'shell' as const, modeCount: 3 };
    const modesOf = (pinned: Uint32Array) => core.findModes(...modesCall(prepared, pinned, settings).values);
    const free = modesOf(new Uint32Array());
    const hinged = modesOf(findPins('low:0', document, prepared));
    expect([free.components[0].zeroModesFound, hinged.components[0].zeroModesFound]).toEqual([6, 1]);
    const clamped = modesOf(findPins('low:20', document, prepared));
    expect(clamped.components[0]).toMatchObject({ zeroModesExpected: 0, zeroModesFound: 0 });
    expect(clamped.modes[0].omega).toBeLessThan(free.modes[0].omega);
  });
});

describe('materials', () => {
  it('are all within the ranges of the settings, and recognised by their values', () => {
    for (const name of MATERIAL_NAMES) {
      const settings = { ...defaultSettings(), ...MATERIALS[name] };
      checkSettings(settings);
      expect(materialNameOf(settings)).toBe(name);
    }
    expect(materialNameOf(defaultSettings())).toBe('rubber');
    expect(materialNameOf({ ...defaultSettings(), density: 7 })).toBeNull();
  });

  it('all give modes although they are thin', () => {
    const { mesh } = core.weld(torus(40, 20).positions, torus(40, 20).triangles, { tolerance: 0 });
    for (const name of MATERIAL_NAMES) {
      const { thickness, ...material } = MATERIALS[name];
      const options = { model: 'shell' as const, modeCount: 4, direction: -1, exact: true, unit: 1 };
      const length = (thickness / 100) * 3.7;
      const set = core.findModes(mesh, {
        ...options,
        ...material,
        thickness: length,
        pinned: new Uint32Array(),
      });
      expect(set.components[0].zeroModesFound).toBe(6);
      for (const { residual } of set.modes) expect(residual).toBeLessThan(1e-6);
    }
  });
});
