/** Attacks by what comes from others: names, counts, keys and texts. SECURITY.md lists what is promised. */

import { strFromU8, strToU8, zipSync } from 'fflate';
import { describe, expect, it, vi } from 'vitest';
import { deviationSvg } from '../../web/app/panels/pictures/deviation_svg';
import { summaryCsv } from '../../web/app/state/queue/summary';
import { readSaved, storeSaved } from '../../web/app/state/saved_text';
import { openAnyModel } from '../../web/engine/document/open';
import { readSettingsFile } from '../../web/engine/report/settings_reader';
import { tableAsCsv } from '../../web/engine/report/tables/method_table';
import { optionsFor, readBatchConfig, settingsFor } from '../../web/engine/settings/batch_config';
import { defaultSettings } from '../../web/engine/settings/methods';
import { SQUARE_OBJ, textFile } from './support/files';

// The state of the page asks the browser whether it is to move.
vi.hoisted(() => vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} })));

const FORMULAS = [
  '=1+1',
  '+1',
  '-1',
  '@SUM(A1)',
  '\t=1',
  '\r=1',
  '\n=1',
  '\uff1d1',
  '\uff0b1',
  '\uff0d1',
  '\uff201',
];

/** Cells of CSV without their quotes. */
const cellsOf = (csv: string): string[] =>
  [...csv.matchAll(/(?:^|,|\r\n)("(?:[^"]|"")*"|[^,\r\n]*)/g)].map(([, text]) => text.replace(/^"/, ''));

describe('no cell of a CSV file starts like a formula', () => {
  it.each(FORMULAS)('of a queue or a table whose names are %j', (name) => {
    const failed = { name, state: 'failed' as const, files: [], sentence: name, finished: null };
    const table = { caption: name, columns: [{ title: name, digits: null }], rows: [[name]] };
    for (const csv of [summaryCsv([failed]), tableAsCsv(table)]) {
      expect(csv).toContain(`'${name}`);
      expect(cellsOf(csv).filter((cell) => /^[=+\-@\t\uff1d\uff0b\uff0d\uff20]/.test(cell))).toEqual([]);
    }
  });
});

describe('a picture', () => {
  it('has no markup of a name', () => {
    const svg = deviationSvg([], '</text><script>alert(1)</script>&"');
    expect(svg).not.toMatch(/<script|<\/text><script/);
    expect(svg).toContain('&lt;script&gt;');
  });
});

/** The bytes of a stream of Draco with these counts and nothing behind them. */
function dracoStream(method: 0 | 1, counts: number[], metadata = false): number[] {
  const varint = (value: number): number[] =>
    value < 128 ? [value] : [(value % 128) + 128, ...varint(Math.floor(value / 128))];
  const head = [...new TextEncoder().encode('DRACO'), 2, 2, 1, method, 0, metadata ? 0x80 : 0];
  // No attribute has metadata, and the mesh has an entry "a" of three bytes.
  const inner = metadata ? [0, 1, 1, 97, 3, 1, 2, 3, 0] : [];
  return [
    ...head,
    ...inner,
    ...(method === 1 ? [0] : []),
    ...counts.flatMap(varint),
    ...Array<number>(40).fill(0),
  ];
}

describe('a Draco bomb', () => {
  const open = (stream: number[]) => {
    const bytes = Uint8Array.from(stream);
    const draco = { KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } } };
    const json = {
      asset: { version: '2.0' },
      extensionsUsed: ['KHR_draco_mesh_compression'],
      extensionsRequired: ['KHR_draco_mesh_compression'],
      buffers: [
        {
          uri: `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`,
          byteLength: bytes.length,
        },
      ],
      bufferViews: [{ buffer: 0, byteLength: bytes.length }],
      accessors: [{ componentType: 5126, type: 'VEC3', count: 3 }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, extensions: draco }] }],
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
    };
    return openAnyModel([textFile('bomb.gltf', JSON.stringify(json))]).then(
      () => '',
      (error: Error) => error.message,
    );
  };

  it.each([
    ['sequential faces', dracoStream(0, [4e8, 10])],
    ['sequential vertices', dracoStream(0, [10, 1e9])],
    ['faces that are walked over', dracoStream(1, [10, 3e8])],
    ['vertices that are walked over', dracoStream(1, [3e8, 10])],
    ['faces behind metadata', dracoStream(0, [4e8, 10], true)],
    [
      'faces of an earlier version',
      [...new TextEncoder().encode('DRACO'), 2, 1, 1, 0, 0, 0, 0, 0, 0, 80, 9, 0, 0, 0],
    ],
  ])('of %s is refused before it is decoded', async (_, stream) => {
    expect(await open(stream)).toMatch(
      /^bomb\.gltf is not a valid glTF file \(the Draco data in buffer view 0 declares more/,
    );
  });

  it('with small declared counts and damaged data is refused by the decoder', async () => {
    expect(await open(dracoStream(0, [1, 3]))).toMatch(/^bomb\.gltf is not a valid glTF file/);
  });
});

describe('a ZIP', () => {
  it('changes no prototype by the name of a file', async () => {
    // Packers refuse the name, so it is put in place of one as long.
    const bytes = zipSync({ 'a.obj': strToU8(SQUARE_OBJ), renamed_9: strToU8('y') });
    const text = strFromU8(bytes, true).replaceAll('renamed_9', '__proto__');
    await openAnyModel([{ name: 'a.zip', bytes: strToU8(text, true) }]).catch(() => null);
    expect(({} as Record<string, unknown>)['0']).toBeUndefined();
    expect(Object.keys(Object.prototype)).toEqual([]);
  });
});

describe('JSON of others', () => {
  const evil = '"__proto__":{"polluted":1,"faces":7},"constructor":{"prototype":{"polluted":1}}';

  it.each([
    `{${evil},"schema":"limber-batch/1"}`,
    `{"schema":"limber-batch/1","options":{${evil}}}`,
    `{"schema":"limber-batch/1","options":{"__proto__":{"faces":7}}}`,
    `{"schema":"limber-batch/1","overrides":[{"files":"**","options":{"__proto__":{"faces":7}}}]}`,
    `{"schema":"limber-batch/1","overrides":[{"files":"**","options":{},"__proto__":{"files":["*"]}}]}`,
  ])('changes no prototype and no option as a configuration: %s', (text) => {
    expect(() => readBatchConfig(text, 'b.json')).toThrow(/^b\.json.*(is unknown|there is no option)/);
    expect('polluted' in {}).toBe(false);
  });

  it('gives a configuration no option that it does not have itself', () => {
    const config = readBatchConfig('{"schema":"limber-batch/1"}', 'b.json');
    const given = JSON.parse('{"__proto__":{"method":"qem"}}') as object;
    const options = optionsFor(config, 'a.obj', given);
    expect(Object.hasOwn(options, 'method')).toBe(false);
    expect(settingsFor(optionsFor(config, 'a.obj', {}))).toEqual(defaultSettings());
    expect('method' in {}).toBe(false);
  });

  it('changes no prototype as a settings file', () => {
    expect(() => readSettingsFile('s.json', `{${evil}}`)).toThrow(/^s\.json/);
    expect('polluted' in {}).toBe(false);
  });
});

describe('what a tab has stored', () => {
  const whole = {
    link: 'method=qem',
    step: 'reduce',
    layout: 'slider',
    field: 'strain',
    undo: { past: ['method=qem'], future: [] },
    hasQueue: true,
    open: 'a1',
  };

  it('is read as it was written', () => {
    expect(readSaved(JSON.stringify(whole))).toEqual(whole);
  });

  it('has only the newest steps of undo if the store is too full', () => {
    const long = { ...readSaved(JSON.stringify(whole)), undo: { past: ['a', 'b', 'c'], future: ['d'] } };
    /** What is kept of `long` where so many letters have room; null: nothing. */
    const keptIn = (room: number): unknown => {
      let kept: string | null = 'earlier';
      const setItem = (_key: string, text: string): void => {
        if (text.length > room) throw new Error('full');
        kept = text;
      };
      storeSaved({ setItem, removeItem: () => (kept = null) }, 'key', long);
      return kept && JSON.parse(kept);
    };
    const { length } = JSON.stringify(long);
    expect(keptIn(length)).toEqual(long);
    expect(keptIn(length - 1)).toEqual({ ...long, undo: { past: ['c'], future: [] } });
    expect(keptIn(length - 13)).toEqual({ ...long, undo: { past: [], future: [] } });
    expect(keptIn(10)).toBeNull();
  });

  it('is cleaned of unknown words and steps', () => {
    const broken = {
      ...whole,
      step: '<b>',
      layout: 7,
      field: null,
      undo: { past: ['faces=-1', 3, 'p=x', 'faces=5'], future: 'no' },
      hasQueue: 1,
      open: 3,
    };
    expect(readSaved(JSON.stringify(broken))).toEqual({
      link: 'method=qem',
      step: 'model',
      layout: 'both',
      field: 'none',
      undo: { past: ['faces=5'], future: [] },
      hasQueue: false,
      open: '',
    });
  });

  it.each(['', 'null', '7', '"x"', '{}', '{"link":3}', '{"link":"", "undo":4}'])(
    'is not used where it is %j',
    (text) => {
      expect(() => readSaved(text)).toThrow();
    },
  );
});
