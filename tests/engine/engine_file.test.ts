import { describe, expect, it } from 'vitest';
import { engineOfText } from '../../web/cli/engine_file';
import { settingsFile, writeSettings } from '../../web/engine/report/settings_file';
import { MATERIALS } from '../../web/engine/settings/materials';
import { tunedBody } from './support/tuned_sheet';

const SILK = MATERIALS.silk;

describe("a file of an engine's parameters", () => {
  it('is an object of numbers, or lines of name=value with comments', () => {
    expect(engineOfText('a.json', '{ "compliance": 1e-5, "friction": 0.3 }').text).toBe(
      'compliance=0.00001,friction=0.3',
    );
    expect(engineOfText('a.txt', 'compliance=1e-5 # soft\n\nfriction=0.3\n').text).toBe(
      'compliance=1e-5,friction=0.3',
    );
  });

  it('is a settings file, of which it takes what the original had, not what was tuned', () => {
    const body = { name: 'sheet', level: 0, renderVertices: [0, 1, 2, 3], tuned: tunedBody('jolt') };
    const settings = settingsFile([body], { ...SILK, bendRatio: 0.05 });
    const { original, engine } = settings;
    const { text, material } = engineOfText('s.json', writeSettings(settings));
    expect(material).toEqual({ ...SILK, bendRatio: 0.05 });
    expect(text).toBe(
      Object.keys(engine)
        .map((name) => `${name}=${original[name]}`)
        .join(','),
    );
    expect(original.compliance).not.toBe(engine.compliance);
    expect(() => engineOfText('s.json', JSON.stringify({ ...settings, bodies: [] }))).toThrow(
      's.json is not a limber-settings/1: write it again with limber optimize --settings.',
    );
  });

  it('says what is not a number, and where', () => {
    expect(() => engineOfText('a.json', '{ "compliance": "soft" }')).toThrow(
      'a.json has "soft" for compliance: give a number.',
    );
    expect(() => engineOfText('a.json', '{ compliance }')).toThrow(/^a\.json is not JSON: /);
  });
});
