// The message table: everything that the page says has a Japanese entry, and nothing is shown without the table.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, expect, test } from 'vitest';
import { preferredLanguage, shown } from '../../web/app/language/language';
import { say, sayCounted, sentence } from '../../web/app/language/say';
import { ENGINE } from '../../web/app/language/japanese/engine';
import { FILE_ERRORS } from '../../web/app/language/japanese/file_errors';
import { FILE_NOTES } from '../../web/app/language/japanese/file_notes';
import { JAPANESE } from '../../web/app/language/japanese/table';
import { METHODS } from '../../web/engine/core/methods';
import { PHASES } from '../../web/engine/core/interface/job';
import { SCENARIOS } from '../../web/engine/core/scenarios';
import { MATERIAL_NAMES } from '../../web/engine/settings/materials';
import { SCENE_ENDS } from '../../web/engine/motion/scene_rotation';
import { OPTIONS } from '../../web/engine/settings/options';
import type { SettingName } from '../../web/engine/settings/options';
import { PRESETS, PRESET_NAMES, settingsOfPreset } from '../../web/engine/settings/presets';
import { describeFinerLevels } from '../../web/engine/report/level_words';
import { METHOD_TITLES, budgetTable } from '../../web/engine/stages/equal_budget/budget_table';
import { SOLVER_NAMES, profileOf } from '../../web/engine/solvers/profiles';
import { collectMessages } from './support/messages';

/** Names, keys of the keyboard, forms to type and what is never shown. */
const EXEMPT = new Set([
  'Limber',
  'limber-hints',
  'LaTeX',
  'GLB',
  'PLY',
  'MSFT_lod',
  '0.25, 10 %, 500',
  'low:6 + box:0,0,0,1,1,1',
  'ball:x,y,z,R',
  'light',
  'dark',
  'system',
]);
const BARE_EXEMPT = /: (Hz|Limber|LOD)$/;

const { keys, numbers, bare } = collectMessages();

const capital = (word: string): string => word[0].toUpperCase() + word.slice(1);

/** What the page shows of the presets: their own words, the settings that they change, and the values that these can have. */
function presetWords(): string[] {
  const names = PRESET_NAMES.flatMap((name) => Object.keys(settingsOfPreset(name)) as SettingName[]);
  return [
    ...PRESET_NAMES.flatMap((name) => [PRESETS[name].label, PRESETS[name].why]),
    ...[...new Set(names)].map((name) => OPTIONS[name].label),
    ...['on', 'off', 'none'],
  ];
}

/** What the page shows of the tables of the engine. */
function engineWords(): string[] {
  const shownByName = [
    'tune',
    'engine',
    'solver',
    'pins',
    'lock',
    'keep',
    'direction',
    'exact',
    'fit',
    'scenario',
    'unit',
    'weld',
    'substeps',
    'minAngle',
    'colliders',
    'compress',
    'lods',
    'format',
    'lodStyle',
  ] as const;
  const onPage = Object.values(OPTIONS).filter(({ page }) => page !== undefined);
  const helped = (
    [
      'pins',
      'keep',
      'direction',
      'fit',
      'scenario',
      'unit',
      'weld',
      'substeps',
      'minAngle',
      'colliders',
      'compress',
      'lodStyle',
    ] as const
  ).map((name) => OPTIONS[name].help);
  const samples = JSON.parse(readFileSync(join(root, 'public', 'samples', 'index.json'), 'utf8')) as Record<
    'id' | 'name' | 'about',
    string
  >[];
  return [
    ...onPage.flatMap(({ label, help }) => [label, help]),
    ...shownByName.map((name) => OPTIONS[name].label),
    ...helped,
    'degrees',
    ...METHODS.flatMap(({ label, title }) => [label, title]),
    ...presetWords(),
    ...Object.values(METHOD_TITLES),
    ...budgetTable([], { model: '', faces: 0, originalFaces: 0 }).columns.map(({ title }) => title),
    ...['kept', 'changed'],
    ...SCENARIOS.flatMap(({ label, sentence: what }) => [label, what]),
    ...SCENE_ENDS.flatMap(({ low, high }) => [low, high]),
    ...SOLVER_NAMES.map(profileOf).flatMap(({ label, words, parameters }) => [
      label,
      words,
      ...parameters.map((one) => one.words),
    ]),
    ...PHASES.slice(1),
    ...MATERIAL_NAMES.map(capital),
    'Custom',
    'Opening',
    ...['bend', 'twist', 'stretch', 'breathe', 'local'],
    ...['Left end', 'Right end', 'Bottom', 'Top', 'Back end', 'Front end'],
    ...samples.flatMap(({ id, name, about }) => [id, name, about]),
  ].filter((word) => word !== '');
}

const root = join(import.meta.dirname, '..', '..');
/** Sentences that the page finds by their form. */
const ofEngine = { ...ENGINE, ...FILE_ERRORS, ...FILE_NOTES };
const used = new Map([...keys, ...engineWords().map((word) => [word, 'web/engine'] as const)]);
const placeholders = (text: string): string[] => [...text.matchAll(/\{\w+\}/g)].map(([name]) => name).sort();

afterEach(() => {
  shown.value = { language: 'en', table: {} };
});

test('everything that the page says has a Japanese entry', () => {
  const missing = [...used].filter(([key]) => !(key in JAPANESE) && !EXEMPT.has(key));
  expect(missing.map(([key, place]) => `${place}: ${key}`)).toEqual([]);
});

test('an entry has the placeholders of its key', () => {
  const wrong = Object.entries(JAPANESE).filter(
    ([key, translated]) => placeholders(key).join() !== placeholders(translated).join(),
  );
  expect(wrong).toEqual([]);
  for (const [one, other] of numbers) expect(placeholders(one)).toEqual(placeholders(other));
});

test('no entry is unused', () => {
  const unused = Object.keys(JAPANESE).filter((key) => !used.has(key) && !(key in ofEngine));
  expect(unused).toEqual([]);
});

test('each entry for engine and viewer has a text there', () => {
  const folders = ['web/engine', 'web/app/worker', 'web/app/viewer'].map((folder) => join(root, folder));
  const sources = folders.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.ts'))
      .map((name) => readFileSync(join(folder, name), 'utf8')),
  );
  const all = sources.join('\n').toLowerCase();
  // Nouns stand apart from their verbs, as their number decides about their form.
  const words = Object.keys(ofEngine).flatMap(
    (key) => key.replaceAll(/\{\w+\}/g, ' ').match(/[A-Za-z]{4,}/g) ?? [],
  );
  const unknown = [...new Set(words)].filter(
    (word) => !all.includes(word.toLowerCase().replace(/(ie)?s$/, '')),
  );
  expect(unknown).toEqual([]);
});

test('nothing is shown without the table', () => {
  expect(bare.filter((literal) => !BARE_EXEMPT.test(literal))).toEqual([]);
});

test('nothing that is shown names a flag of the command line', () => {
  expect(Object.keys(JAPANESE).filter((key) => /(^|\s)--[a-z]/.test(key))).toEqual([]);
});

test('a sentence has its values in both languages', () => {
  expect(say('Keep {count} faces', { count: '1,000' })).toBe('Keep 1,000 faces');
  expect(sayCounted(1, '{count} part', '{count} parts')).toBe('1 part');
  expect(sayCounted(1200, '{count} part', '{count} parts')).toBe('1,200 parts');
  expect(sentence('Nothing of this kind.')).toBe('Nothing of this kind.');
  shown.value = { language: 'ja', table: JAPANESE };
  expect(say('Keep {count} faces', { count: '1,000' })).toBe('1,000 面を残す');
  expect(sayCounted(1, '{count} part', '{count} parts')).toBe('1 パーツ');
  expect(say('A sentence without an entry.')).toBe('A sentence without an entry.');
});

test('a sentence of the engine is recognised by its form', () => {
  shown.value = { language: 'ja', table: JAPANESE };
  expect(sentence('12 seam vertices welded')).toBe('シームの頂点 12 個を結合');
  expect(sentence('It cannot be removed: a face would flip.')).toBe('取り除けません: 面が裏返ります。');
  expect(sentence('Modes 1 and 2 strain different places (7 % in common): faces stay at both.')).toBe(
    'モード 1 と 2 は異なる場所をひずませます (共通 7 %)。両方の場所に面を残します。',
  );
  expect(sentence('Nothing is known of this.')).toBe('Nothing is known of this.');
  expect(sentence('convert it to GLB')).toBe('convert it to GLB');
});

test('the warning of a further level with more faces than the result is recognised by its form', () => {
  const levels = [90, 1200].map((faces, i) => ({ file: `a_lod${i}.glb`, faces }));
  const told = describeFinerLevels(1000, levels, '“Further levels”');
  expect(told).toHaveLength(1);
  shown.value = { language: 'ja', table: JAPANESE };
  expect(sentence(`${told[0]}.`)).toMatch(
    /^a_lod1.glb: 追加の LOD は 1,200 面で、結果の 1,000 面より.*「追加の LOD」/,
  );
});

test('notes of the reader on a file are recognised by their form', () => {
  shown.value = { language: 'ja', table: JAPANESE };
  expect(sentence('1 animation: the rest pose is used')).toBe('アニメーション 1: 静止時の姿勢を使用');
  expect(sentence('default weights of morph targets: measurements and motion use weights of 0')).toBe(
    'モーフターゲットの初期の重み: 測定と動きでは重みを 0 とします',
  );
  expect(sentence('2 skins and 1 animation: the rest pose is used')).toBe(
    'スキン 2、アニメーション 1: 静止時の姿勢を使用',
  );
  expect(sentence('3 polygons with more than three corners cut into triangles')).toBe(
    '多角形 3 個を三角形に分割',
  );
});

test('the first supported language of the browser is chosen', () => {
  expect(preferredLanguage(['de-DE', 'ja-JP', 'en'])).toBe('ja');
  expect(preferredLanguage(['en-GB', 'ja'])).toBe('en');
  expect(preferredLanguage(['fr'])).toBe('en');
});
