import { describe, expect, it } from 'vitest';
import { engineOfText } from '../../web/cli/engine_file';

describe("a file of an engine's parameters", () => {
  it('is an object of numbers, or lines of name=value with comments', () => {
    expect(engineOfText('a.json', '{ "compliance": 1e-5, "friction": 0.3 }')).toBe(
      'compliance=0.00001,friction=0.3',
    );
    expect(engineOfText('a.txt', 'compliance=1e-5 # soft\n\nfriction=0.3\n')).toBe(
      'compliance=1e-5,friction=0.3',
    );
  });

  it('is a settings file, of which it takes what the original had, not what was tuned', () => {
    const settings = {
      schema: 'limber-settings/1',
      engine: { compliance: 2e-4, friction: 0.3 },
      original: { vertices: 4, totalMass: 2, stretch: 1e4, bend: 1, compliance: 1e-4, friction: 0.2 },
    };
    expect(engineOfText('s.json', JSON.stringify(settings))).toBe('compliance=0.0001,friction=0.2');
  });

  it('says what is not a number, and where', () => {
    expect(() => engineOfText('a.json', '{ "compliance": "soft" }')).toThrow(
      'a.json has "soft" for compliance: give a number.',
    );
    expect(() => engineOfText('a.json', '{ compliance }')).toThrow(/^a\.json is not JSON: /);
  });
});
