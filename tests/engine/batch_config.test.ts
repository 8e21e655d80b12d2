/** The pure parts of batches: patterns, configurations, keys, journals, summaries, pictures. */

import { appendFileSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inflateSync } from 'node:zlib';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import {
  optionsFor,
  readBatchConfig,
  settingsFor,
  writeBatchConfig,
} from '../../web/engine/settings/batch_config';
import type { AssetOptions } from '../../web/engine/settings/batch_config';
import { matchesPath } from '../../web/engine/settings/path_pattern';
import { defaultSettings } from '../../web/engine/settings/options';
import type { SettingName } from '../../web/engine/settings/options';
import { crewOf } from '../../web/cli/batch/batch';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { Journal } from '../../web/cli/batch/journal';
import { hashOf, keyOf } from '../../web/cli/batch/key';
import { LineFile } from '../../web/cli/batch/line_file';
import { optionsOfFlags } from '../../web/cli/batch/orders';
import { cameraOn } from '../../web/cli/batch/picture/camera';
import { encodePng } from '../../web/cli/batch/picture/png';
import { draw } from '../../web/cli/batch/picture/raster';
import { BatchProgress, sentenceOn } from '../../web/cli/batch/progress';
import { failedRecord, NO_NUMBERS } from '../../web/cli/batch/record';
import type { AssetRecord } from '../../web/cli/batch/record';
import { assetsOf } from '../../web/cli/batch/sources';
import { reasonToDo } from '../../web/cli/batch/stale';
import { summaryOf } from '../../web/cli/batch/summary';
import { summaryCsv } from '../../web/cli/batch/summary_csv';
import { cell } from '../../web/engine/report/tables/csv_cell';
import { summaryHtml } from '../../web/cli/batch/summary_html';
import { textFile } from './support/files';
import { processorTime } from './support/processor_time';

const config = (value: object) =>
  readBatchConfig(JSON.stringify({ schema: 'limber-batch/1', ...value }), 'b.json');

describe('patterns of paths', () => {
  it.each([
    ['*.obj', 'a/b/c.obj', true],
    ['props/*.obj', 'props/a.obj', true],
    ['props/*.obj', 'props/x/a.obj', false],
    ['props/**', 'props/x/a.obj', true],
    ['props/**/*.obj', 'props/a.obj', true],
    ['**/x/**/*.obj', 'x/a.obj', true],
    ['**/x/**/*.obj', 'p/q/x/r/s/a.obj', true],
    ['**/x/**/*.obj', 'p/q/y/a.obj', false],
    ['a?.{obj,ply}', 'a1.ply', true],
    ['a?.{obj,ply}', 'a1.stl', false],
    ['props/**', 'propsy/a.obj', false],
    ['[1].obj', '[1].obj', true],
    ['./a/*.obj', 'a/b.obj', true],
  ])('%s and %s: %s', (pattern, path, isMatch) => {
    expect(matchesPath(pattern, path)).toBe(isMatch);
  });

  it('take time in proportion to the product of the lengths at most', () => {
    const seconds = processorTime();
    expect(matchesPath(`${'**/'.repeat(200)}z`, `${'a/'.repeat(2000)}y`)).toBe(false);
    expect(seconds()).toBeLessThan(2);
  });
});

describe('configurations', () => {
  it('take precedence in the order options, flags, overrides', () => {
    const read = config({
      options: { ratio: 0.5, strainWeight: 2, p: 'inf' },
      overrides: [
        { files: 'hero/**', options: { ratio: 0.9 } },
        { files: ['*.ply'], options: { method: 'qem' } },
      ],
    });
    const flags = { ratio: 0.3 };
    expect(optionsFor(read, 'a.obj', flags)).toEqual({ ratio: 0.3, strainWeight: 2, p: Infinity });
    expect(optionsFor(read, 'hero/a.obj', flags).ratio).toBe(0.9);
    const ply = settingsFor(optionsFor(read, 'hero/a.ply', flags));
    expect(ply).toEqual({ ...defaultSettings('qem'), strainWeight: 2, p: Infinity });
  });

  it.each([
    ['{', /^b\.json is not JSON, from line 1, column 2: check its commas, quotes and brackets\.$/],
    ['[]', /^b\.json is not an object/],
    [
      '{"schema":"limber-batch/9"}',
      /^b\.json has the schema "limber-batch\/9": give "schema": "limber-batch\/1"\.$/,
    ],
    ['{"schema":"limber-batch/1","option":{}}', /^b\.json has "option", which is unknown/],
    ['{"schema":"limber-batch/1","options":{"ratio":2}}', /options: ratio is 2: give a number above 0/],
    ['{"schema":"limber-batch/1","options":{"toString":2}}', /options: there is no option "toString"/],
    ['{"schema":"limber-batch/1","options":{"threads":2}}', /threads depends on the machine/],
    [
      '{"schema":"limber-batch/1","overrides":[{"files":"a","options":{"fit":"x"}}]}',
      /^b\.json: overrides\[0\]\.options: fit is "x": give one of surface/,
    ],
    ['{"schema":"limber-batch/1","overrides":[{"files":[],"options":{}}]}', /files is empty/],
    [
      `{"schema":"${'9'.repeat(500)}"}`,
      /^b\.json has the schema "9{100}\.\.\.": give "schema": "limber-batch\/1"\.$/,
    ],
    [
      '{"schema":"limber-batch/1","options":{"modeCount":{"a":1}}}',
      'b.json: options: modeCount is {"a":1}: give a whole number from 1 to 100 (default: 12).',
    ],
  ])('%s is refused in a sentence', (text, sentence) => {
    expect(() => readBatchConfig(text, 'b.json')).toThrow(sentence);
  });

  it('of settings are read back as the settings, without those about one file', () => {
    const settings = {
      ...defaultSettings('qem'),
      strainWeight: 3,
      p: Infinity,
      lods: [0.5, 0.1],
      threads: 3,
    };
    const text = writeBatchConfig(settings, { ratio: 0.25 });
    const { options } = readBatchConfig(text, 'b.json');
    expect(options.ratio).toBe(0.25);
    expect(settingsFor(options)).toEqual({ ...settings, threads: 0 });
  });

  it('take only the flags that were given', () => {
    const words = 'batch src out --ratio 0.3 --material-preset silk --young 5 --soft --threads 2';
    const options = optionsOfFlags(parseArguments(words.split(' ')) as Arguments);
    expect(options).toMatchObject({ ratio: 0.3, soft: true, young: 5 });
    expect(Object.keys(options).sort()).toEqual(
      ['density', 'poisson', 'ratio', 'soft', 'thickness', 'young'].sort(),
    );
  });
});

describe('what is up to date', () => {
  const files = [textFile('a.gltf', 'x'), textFile('a.bin', 'y')];
  const record: AssetRecord = {
    ...{ asset: 'a', state: 'done', key: 'k', sentences: [], ...NO_NUMBERS },
    written: [{ name: 'a.glb', bytes: 1, sha256: 'h' }],
  };

  it('is recognised by a key of everything that results depend on', () => {
    const keyFor = (options: AssetOptions, of = files, fromPreset: SettingName[] = []) =>
      keyOf(of, { options, fromPreset }, 'a.glb');
    const key = keyFor({ ratio: 0.5 });
    expect(keyFor({ ratio: 0.5, threads: 4 }, [...files])).toBe(key);
    const others = [
      keyFor({ ratio: 0.5 }, [files[0], textFile('a.bin', 'z')]),
      keyFor({ ratio: 0.5 }, [files[0]]),
      keyFor({ ratio: 0.5 }, [files[0], textFile('b.bin', 'y')]),
      keyFor({ ratio: 0.4 }),
      keyFor({ ratio: 0.5, p: Infinity }),
      keyFor({ ratio: 0.5, p: Infinity }, files, ['p']),
      keyOf(files, { options: { ratio: 0.5 }, fromPreset: [] }, 'b.glb'),
    ];
    expect(new Set([key, ...others]).size).toBe(8);
  });

  it('has the same key, and results as they were written', async () => {
    const same = () => Promise.resolve('k');
    expect(await reasonToDo(record, same, () => 'h')).toBe(null);
    expect(await reasonToDo(undefined, same, () => 'h')).toBe('new');
    expect(
      await reasonToDo(
        record,
        () => Promise.resolve('l'),
        () => 'h',
      ),
    ).toBe('changed');
    expect(await reasonToDo(record, same, () => null)).toBe('result missing');
    expect(await reasonToDo(record, same, () => 'i')).toBe('result changed');
    expect(await reasonToDo({ ...record, state: 'failed' }, same, () => 'h')).toBe('failed before');
  });

  it('separates two assets that would have one result file', () => {
    const sources = ['a.obj', 'a.ply', 'b/a.obj', 'c.d.obj'].map((name) => ({ name, path: name, bytes: 1 }));
    const results = (platform: NodeJS.Platform) =>
      assetsOf(sources, undefined, platform).map(({ result }) => result);
    expect(results('linux')).toEqual(['a.obj.glb', 'a.ply.glb', 'b/a.glb', 'c.d.glb']);
    const chain = ['a.obj', 'a.obj.obj', 'a.obj.obj.stl', 'a.ply'].map((name) => ({
      name,
      path: name,
      bytes: 1,
    }));
    expect(new Set(assetsOf(chain).map(({ result }) => result)).size).toBe(4);
    const cased = ['A.obj', 'a.ply'].map((name) => ({ name, path: name, bytes: 1 }));
    expect(assetsOf(cased, undefined, 'linux')[0].result).toBe('A.glb');
    expect(assetsOf(cased, () => 'ply', 'win32')[0].result).toBe('A.obj.ply');
  });
});

describe('the journal', () => {
  let folder: string;
  beforeAll(() => {
    folder = mkdtempSync(join(tmpdir(), 'limber-journal-'));
  });
  afterAll(() => rmSync(folder, { recursive: true, force: true }));

  it('contains what was finished, whatever it ends with, also after it is compacted', () => {
    const journal = new Journal(folder);
    journal.add(failedRecord('a', 'no'));
    journal.add(failedRecord('b', 'no'));
    appendFileSync(join(folder, 'journal.jsonl'), '{"asset":"c","key":"x","state":"do');
    const second = new Journal(folder);
    expect(second.all().map(({ asset }) => asset)).toEqual(['a', 'b']);
    second.add(failedRecord('d', 'no'));
    const third = new Journal(folder);
    expect(third.all().map(({ asset }) => asset)).toEqual(['a', 'b', 'd']);
    third.gather();
    // A kill between the two steps of gathering leaves lines that the manifest has, too.
    appendFileSync(join(folder, 'journal.jsonl'), `${JSON.stringify(failedRecord('a', 'later'))}\n`);
    expect(new Journal(folder).all().map(({ asset, sentences }) => [asset, sentences[0]])).toEqual([
      ['a', 'later'],
      ['b', 'no'],
      ['d', 'no'],
    ]);
  });

  it.each(['', '{"schema":"limber-batchmanifest/1","assets":[{"asset":1}]}', '{"schema":"x"}', 'ÿ\0{'])(
    'says so where the manifest is damaged: %j',
    (text) => {
      writeFileSync(join(folder, 'manifest.json'), text);
      rmSync(join(folder, 'journal.jsonl'), { force: true });
      const notes: string[] = [];
      expect(new Journal(folder, notes).all()).toEqual([]);
      expect(notes).toEqual([expect.stringMatching(/manifest\.json is damaged or of another version/)]);
    },
  );
});

it.skipIf(!existsSync('/dev/full'))('a journal on a full disk says so in a sentence', () => {
  const file = new LineFile('/dev/full');
  expect(() => file.add('done')).toThrow('/dev/full cannot be written: the disk is full.');
  file.close();
});

describe('the summary', () => {
  const evil = '=HYPERLINK("x"),<script>alert(1)</script>.obj';
  const rows = [{ ...failedRecord(evil, '+1 & "2"'), isUnchanged: false }];
  const summary = summaryOf(rows, 1);

  it('has no cell that a spreadsheet would run, and no markup of names', () => {
    for (const text of ['=1', '+1', '-1', '@x', '\t=1', '\r=1']) expect(cell(text)).toMatch(/^"?'/);
    expect([cell('a,b'), cell('a"b'), cell(-1.5), cell(null), cell('a=1')]).toEqual([
      '"a,b"',
      '"a""b"',
      '-1.5',
      '',
      'a=1',
    ]);
    expect(summaryCsv(summary)).toContain(`"'=HYPERLINK(""x""),<script>alert(1)</script>.obj",failed`);
    const html = summaryHtml(summary, () => null);
    expect(html).not.toContain('<script');
    expect(html).toContain('&lt;script&gt;alert(1)&lt;/script&gt;');
    expect(html).toContain('+1 &amp; &quot;2&quot;');
    expect(html).toMatch(/^<!doctype html>\n<!-- Limber \d/);
  });

  it('begins as CSV with the mark by which Excel knows UTF-8, and once', () => {
    const csv = summaryCsv(summaryOf([{ ...failedRecord('набор.obj', 'no'), isUnchanged: false }], 1));
    expect(csv.split('\ufeff')).toEqual(['', expect.stringMatching(/^asset,state,/)]);
    expect(Buffer.from(csv).subarray(0, 3).toString('hex')).toBe('efbbbf');
    expect(csv).toContain('\r\nнабор.obj,failed');
  });

  it('links to the model of a result, not to its companions, whatever its characters', () => {
    const names = ['a.bin', 'x/50 % "off" #1?.gltf', 'x/50 % "off" #1?_lod1.gltf'];
    const written = names.map((name) => ({ name, bytes: 1, sha256: '' }));
    const done = { ...failedRecord('b', ''), state: 'done' as const, written, isUnchanged: false };
    const html = summaryHtml(summaryOf([done], 1), () => null);
    expect(html.match(/href="[^"]*"/g)).toEqual(['href="x/50%20%25%20%22off%22%20%231%3F.gltf"']);
    expect(html).toContain('>x/50 % &quot;off&quot; #1?.gltf</a>');
    expect(summaryCsv(summaryOf([done], 1))).toContain('"x/50 % ""off"" #1?.gltf"');
    expect(summaryHtml(summary, () => null)).not.toContain('href');
  });

  it('does not count the faces of failed assets', () => {
    const done = {
      ...failedRecord('b', ''),
      state: 'done' as const,
      facesBefore: 10,
      facesAfter: 5,
      isUnchanged: true,
    };
    expect(summaryOf([...rows, done], 2).totals).toMatchObject({
      ...{ assets: 2, done: 1, failed: 1, unchanged: 1, facesBefore: 10, facesAfter: 5 },
    });
  });
});

describe('pictures', () => {
  const square = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0]);
  const front = {
    ...cameraOn(square),
    axes: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const,
    origin: [-0.5, -0.5] as const,
    span: 2,
  };

  it('cover the pixels whose centres a triangle covers', () => {
    const { pixels } = draw(square, front, 8);
    const covered = Array.from(pixels, (value) => (value < 250 ? '#' : '.')).join('');
    expect(covered.match(/.{8}/g)).toEqual([
      ...['........', '........', '..####..', '..####..', '..####..', '..####..', '........', '........'],
    ]);
  });

  it('show the nearest triangle, in any order of drawing', () => {
    const tilted = new Float32Array([0, 0, 1, 1, 0, 1, 1, 1, 2, 0, 0, 1, 1, 1, 2, 0, 1, 2]);
    const both = (first: Float32Array, second: Float32Array) =>
      draw(new Float32Array([...first, ...second]), front, 8).pixels;
    expect(both(square, tilted)).toEqual(both(tilted, square));
    expect(both(square, tilted)).toEqual(draw(tilted, front, 8).pixels);
  });

  it('are drawn with non-finite points, and with no triangles', () => {
    const odd = new Float32Array([NaN, 0, 0, Infinity, 0, 0, 1, 1, 0]);
    expect(draw(odd, cameraOn(odd), 4).pixels.every((value) => value === 250)).toBe(true);
    expect(draw(new Float32Array(0), cameraOn(new Float32Array(0)), 4).pixels).toHaveLength(16);
  });

  it('are PNG files that other programs read', () => {
    const bytes = Buffer.from(encodePng({ width: 2, height: 2, pixels: new Uint8Array([1, 2, 3, 4]) }));
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    const length = bytes.readUInt32BE(33);
    expect([...inflateSync(bytes.subarray(41, 41 + length))]).toEqual([0, 1, 2, 0, 3, 4]);
    // The checksum of an empty end is in every PNG.
    expect(bytes.subarray(-4).toString('hex')).toBe('ae426082');
  });
});

describe('a crew', () => {
  const args = (...words: string[]) => parseArguments(['batch', 'a', 'b', ...words]) as Arguments;

  it('divides the cores among jobs, and never has more jobs than assets', () => {
    expect(crewOf(args(), 100, 8)).toMatchObject({ jobs: 8, threads: 1 });
    expect(crewOf(args('--jobs', '2'), 100, 8)).toMatchObject({ jobs: 2, threads: 4 });
    expect(crewOf(args('--jobs', '2', '--threads', '1'), 100, 8)).toMatchObject({ jobs: 2, threads: 1 });
    expect(crewOf(args(), 1, 64)).toMatchObject({ jobs: 1, threads: 8 });
    expect(crewOf(args('--memory', '100'), 100, 8).memory).toBe(100 * 2 ** 20);
  });
});

describe('progress', () => {
  const said = (isTTY: boolean) => {
    let text = '';
    const stream = {
      isTTY,
      columns: 40,
      write: (part: string | Uint8Array) => ((text += String(part)), true),
    };
    const progress = new BatchProgress(2, { quiet: false, stream });
    progress.begin('a\n\u001b[31m.obj');
    progress.end(failedRecord('a\n\u001b[31m.obj', 'no'), false);
    progress.clear();
    return text;
  };

  it('is a line for each asset, and on terminals a status line without escape sequences', () => {
    expect(said(false)).toBe('[1/2] a ?[31m.obj: failed: no\n');
    expect(said(true)).toContain('\r1 of 2 assets, 1 failed: ');
    expect(said(true)).not.toContain('\u001b');
    expect(said(true).match(/\n/g)).toHaveLength(1);
  });

  it('ends with sentences that name each asset once and have one full stop', () => {
    expect(sentenceOn('a/b.obj', 'b.obj, line 1: "x" is not OBJ: is it a mesh?')).toBe(
      'a/b.obj, line 1: "x" is not OBJ: is it a mesh?',
    );
    expect(sentenceOn('b.obj', 'b.object is missing.')).toBe('b.obj: b.object is missing.');
    expect(sentenceOn('b.obj', 'stopped at 5 faces')).toBe('b.obj: stopped at 5 faces.');
    expect(sentenceOn('a\r/b\nc.obj', 'b c.obj has no faces.')).toBe('a?/b c.obj has no faces.');
  });
});

it('hashes as SHA-256 does', () => {
  expect(hashOf('abc')).toMatch(/^ba7816bf8f01cfea/);
  expect(readFileSync(join(import.meta.dirname, '../../docs/batch.schema.json'), 'utf8')).toContain(
    'limber-batch/1',
  );
});
