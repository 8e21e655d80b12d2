import { afterAll, describe, expect, it } from 'vitest';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { engineOfText } from '../../web/cli/engine_file';
import { settingsFile, writeSettings } from '../../web/engine/report/settings_file';
import { parseEngine } from '../../web/engine/settings/engine_text';
import { MATERIALS } from '../../web/engine/settings/materials';
import { tunedBody } from './support/tuned_sheet';

const SILK = MATERIALS.silk;
const folder = mkdtempSync(join(tmpdir(), 'limber-engine-'));
afterAll(() => rmSync(folder, { recursive: true }));

const sheet = () => ({
  ...{ name: 'sheet', level: 0, meshNumber: 0, renderVertices: [0, 1, 2, 3] },
  tuned: tunedBody('jolt'),
});

describe("a file of an engine's parameters", () => {
  it('is an object of numbers, or lines of name=value with comments', () => {
    expect(engineOfText('a.json', '{ "compliance": 1e-5, "friction": 0.3 }').text).toBe(
      'compliance=0.00001,friction=0.3',
    );
    expect(engineOfText('a.txt', 'compliance=1e-5 # soft\n\nfriction=0.3\n').text).toBe(
      'compliance=1e-5,friction=0.3',
    );
  });

  it('can be a settings file, of which the parameters of the original are taken, not the tuned ones', () => {
    const settings = settingsFile([sheet()], { ...SILK, bendRatio: 0.05, engine: 'mCompliance=1e-5' });
    const { original, engine } = settings;
    const { text, material } = engineOfText('s.json', writeSettings(settings));
    expect(material).toEqual({ ...SILK, bendRatio: 0.05 });
    expect(text).toBe(`compliance=${original.compliance}`);
    expect(original.compliance).not.toBe(engine.compliance);
    expect(() => engineOfText('s.json', JSON.stringify({ ...settings, bodies: [] }))).toThrow(
      's.json has no bodies: write it again with limber optimize --settings.',
    );
  });

  it('can be a settings file without a list of given parameters, of which all are taken', () => {
    const { given, ...earlier } = settingsFile([sheet()], { ...SILK, bendRatio: 0.05, engine: '' });
    const { original, engine } = earlier;
    expect(given).toEqual([]);
    expect(engineOfText('s.json', JSON.stringify(earlier)).text).toBe(
      Object.keys(engine)
        .map((name) => `${name}=${original[name]}`)
        .join(','),
    );
  });

  it('lets another material override the parameters that were derived from its own', () => {
    const settings = { ...SILK, bendRatio: 0.05, engine: 'compliance=1e-5' };
    const file = join(folder, 's.json');
    writeFileSync(file, writeSettings(settingsFile([sheet()], settings)));
    const words = ['tune', 'a.obj', 'b.obj', '--solver', 'jolt', '--settings', 'o.json', '--engine', file];
    const settingsOf = (...more: string[]) => (parseArguments([...words, ...more]) as Arguments).settings;
    expect(settingsOf()).toMatchObject({ ...SILK, engine: expect.stringMatching(/^compliance=[^,]+$/) });
    expect(settingsOf('--material-preset', 'rubber')).toMatchObject(MATERIALS.rubber);
    expect(settingsOf('--density', '7')).toMatchObject({ ...SILK, density: 7 });
  });

  it('lets another material do so as well where the file does not list the given ones', () => {
    const file = join(folder, 'earlier.json');
    const { given, ...earlier } = settingsFile([sheet()], { ...SILK, bendRatio: 0.05, engine: '' });
    expect(given).toEqual([]);
    writeFileSync(file, JSON.stringify(earlier));
    const words = ['tune', 'a.obj', 'b.obj', '--solver', 'jolt', '--settings', 'o.json', '--engine', file];
    const namesOf = (...more: string[]) =>
      Object.keys(parseEngine((parseArguments([...words, ...more]) as Arguments).settings.engine));
    const all = Object.keys(earlier.engine);
    const without = (...names: string[]) => all.filter((name) => !names.includes(name));
    expect(namesOf()).toEqual(all);
    expect(namesOf('--density', '7')).toEqual(without('invMass'));
    expect(namesOf('--young', '1e7').filter((name) => /compliance/i.test(name))).toEqual([]);
    expect(namesOf('--young', '1e7')).toContain('invMass');
    expect(namesOf('--material-preset', 'rubber')).not.toContain('invMass');
  });

  it('says what is not a number, and where', () => {
    expect(() => engineOfText('a.json', '{ "compliance": "soft" }')).toThrow(
      'a.json has "soft" for compliance: give a number.',
    );
    expect(() => engineOfText('a.json', '{ compliance }')).toThrow(/^a\.json is not JSON: /);
  });
});
