import { Document } from '@gltf-transform/core';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { NONE } from '../../web/engine/core/core';
import { constraintsOf } from '../../web/engine/body/constraints';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import {
  keepOfLevels,
  lockedIn,
  painted,
  paintOn,
  unweldLevels,
  weldLevels,
} from '../../web/engine/body/paint';
import { LOCKED, parsePaint, STRONGEST, withPaint } from '../../web/engine/settings/paint_text';
import { historyCall } from '../../web/engine/stages/history';
import { prepareBody } from '../../web/engine/stages/prepared';
import { simplificationSettings } from '../../web/engine/stages/simplification';
import { bodyOf } from './support/bodies';
import { loadTestCore } from './support/core';
import { torus } from './support/shapes';

const someLevels = fc.uint8Array({ max: LOCKED, minLength: 1, maxLength: 400 });

describe('painted levels as text', () => {
  it('are read back as they were', () => {
    fc.assert(
      fc.property(someLevels, fc.nat(20), (levels, mesh) => {
        const back = parsePaint(withPaint('', mesh, levels));
        if (levels.every((level) => level === 0)) expect(back.size).toBe(0);
        else expect(back.get(mesh)).toEqual(levels);
      }),
      { seed: 5 },
    );
  });

  it('of several meshes do not affect each other', () => {
    const [a, b] = [Uint8Array.of(0, 3, 3), Uint8Array.of(LOCKED)];
    const text = withPaint(withPaint('', 4, b), 0, a);
    expect(parsePaint(text)).toEqual(
      new Map([
        [0, a],
        [4, b],
      ]),
    );
    expect(withPaint(text, 0, new Uint8Array(3))).toBe(withPaint('', 4, b));
  });

  it('are short if little is painted', () => {
    const levels = new Uint8Array(1_000_000);
    levels.fill(LOCKED, 5000, 5200);
    expect(withPaint('', 0, levels).length).toBeLessThan(20);
  });

  it.each(['vertices:1', '0:', '0:%%', '0:AAAA+', '0:Pw'])('"%s" is refused', (text) => {
    expect(() => parsePaint(text)).toThrow('“Painted” is not text from the brush of the page: copy it');
  });
});

describe('painted levels on a welded mesh', () => {
  it('are the highest among welded vertices, and map back to all of them', () => {
    const vertexOfSource = Uint32Array.of(0, 1, 1, NONE, 2);
    const welded = weldLevels(Uint8Array.of(1, 2, 7, 9, 0), vertexOfSource, 3);
    expect(welded).toEqual(Uint8Array.of(1, 7, 0));
    expect(unweldLevels(welded, vertexOfSource)).toEqual(Uint8Array.of(1, 7, 7, 0, 0));
  });

  it('are keep weights of 1 at the strongest level and locks above it', () => {
    const levels = Uint8Array.of(0, STRONGEST / 2, STRONGEST, LOCKED);
    expect(keepOfLevels(levels)).toEqual(Float32Array.of(0, 0.5, 1, 1));
    expect(lockedIn(levels)).toEqual([3]);
  });

  it('only grow under the brush and are removed only by the eraser', () => {
    expect(painted(0, 'keep', 1)).toBe(STRONGEST);
    expect(painted(8, 'keep', 0.5)).toBe(8);
    expect(painted(LOCKED, 'keep', 1)).toBe(LOCKED);
    expect(painted(3, 'lock', 0.1)).toBe(LOCKED);
    expect(painted(LOCKED, 'erase', 0.1)).toBe(0);
  });
});

const core: Core = await loadTestCore(1);
const shape = torus(24, 16);

describe('a painted body', () => {
  const prepared = prepareBody(core, bodyOf(shape), defaultSettings('qem'));
  const curvature = core.meanCurvature(prepared.mesh);
  const half = (sign: number, level: number) =>
    withPaint(
      '',
      0,
      Uint8Array.from({ length: shape.positions.length / 3 }, (_, v) =>
        sign * shape.positions[3 * v] > 0 ? level : 0,
      ),
    );
  const reduced = (paint: string, method: Settings['method'], faces: number) => {
    const settings = { ...defaultSettings(method), paint, maxDeviation: 0 };
    const { constraints } = constraintsOf(new Document(), prepared, new Uint32Array(), settings);
    const guides = { guidance: null, curvature, constraints, costs: null };
    const { values } = historyCall(prepared, guides, simplificationSettings(settings));
    const history = core.simplify(...values);
    return core.meshAt(prepared.mesh, history, faces).mesh;
  };
  const share = ({ positions }: { positions: Float32Array }) =>
    positions.filter((x, i) => i % 3 === 0 && x > 0).length / (positions.length / 3);

  it.each(['limber', 'qem', 'paper'] as const)(
    'keeps more vertices under %s where they are painted',
    (method) => {
      expect(share(reduced(half(1, STRONGEST), method, 280))).toBeGreaterThan(0.7);
      expect(share(reduced(half(-1, STRONGEST), method, 280))).toBeLessThan(0.3);
    },
  );

  it.each(['limber', 'qem', 'paper'] as const)(
    'keeps its locked vertices under %s at the floor',
    (method) => {
      const { positions } = reduced(half(1, LOCKED), method, 0);
      const positionsLeft = new Set<string>();
      for (let v = 0; v < positions.length; v += 3) positionsLeft.add(positions.subarray(v, v + 3).join(' '));
      for (let v = 0; v < shape.positions.length; v += 3)
        if (shape.positions[v] > 0)
          expect(positionsLeft).toContain(shape.positions.subarray(v, v + 3).join(' '));
    },
  );

  it('refuses the paint of a different file', () => {
    const paint = withPaint('', 0, Uint8Array.of(1, 2));
    expect(() => paintOn(paint, prepared)).toThrow('“Painted” is for 2 vertices, but "');
  });
});
