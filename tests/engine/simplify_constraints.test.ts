import { describe, expect, it } from 'vitest';
import type { Core, MeshAt, SimplifyOptions, TriangleMesh } from '../../web/engine/core/core';
import { VERDICTS } from '../../web/engine/core/core';
import { loadTestCore } from './support/core';
import { torus } from './support/shapes';

const limber: SimplifyOptions = {
  method: 'limber',
  strainWeight: 3,
  curvatureWeight: 0,
  qualityWeight: 0.1,
  sizeWeight: 0.01,
};
const none = new Float32Array();

const core: Core = await loadTestCore(1);
const { mesh } = core.weld(torus(24, 16).positions, torus(24, 16).triangles, { tolerance: 0 });
const vertexCount = mesh.positions.length / 3;
const faceCount = mesh.triangles.length / 3;

function floorOf(options: SimplifyOptions): MeshAt {
  return core.meshAt(mesh, core.simplify(mesh, none, none, options), 0);
}
const point = ({ positions }: TriangleMesh, v: number) => [...positions.subarray(3 * v, 3 * v + 3)];

describe('constraints through the core', () => {
  it('leave a locked vertex in place', () => {
    const locked = new Uint8Array(vertexCount);
    locked[7] = 1;
    const floor = floorOf({ ...limber, constraints: { locked } });
    expect(point(floor.mesh, floor.vertexOfInput[7])).toEqual(point(mesh, 7));
  });

  it('keep both sides of a border between groups, and the members of a pinned set', () => {
    const groups = Uint32Array.from({ length: faceCount }, (_, t) =>
      mesh.positions[3 * mesh.triangles[3 * t]] > 0.2 ? 1 : 0,
    );
    const pinnedSets = Uint32Array.from({ length: vertexCount }, (_, v) => (v < 40 ? 2 : 0));
    const floor = floorOf({ ...limber, constraints: { groups, pinnedSets, borders: 'fixed' } });
    expect(new Set([...floor.inputOfTriangle].map((t) => groups[t]))).toEqual(new Set([0, 1]));
    for (let v = 0; v < 40; v++) expect(pinnedSets[floor.inputOfVertex[floor.vertexOfInput[v]]]).toBe(2);
  });

  it('leave a history that says why it ends', () => {
    const stop = (options: Partial<SimplifyOptions>) =>
      core.simplify(mesh, none, none, { ...limber, ...options }).stop;
    expect(stop({})).toBe('exhausted');
    expect(stop({ stopFaces: 100 })).toBe('target');
    expect(stop({ maxDeviation: 0.01 })).toBe('deviation');
    expect(stop({ minAngle: 35 })).toBe('angle');
  });

  it('explain for every vertex why it is kept', () => {
    const history = core.simplify(mesh, none, none, limber);
    const why = core.whyKept({ mesh, strain: none, curvature: none, options: limber, history }, 200);
    const { mesh: at } = core.meshAt(mesh, history, 200);
    expect(why.error.length).toBe(at.positions.length / 3);
    expect([...why.size].every((value) => value > 0)).toBe(true);
    expect([...why.strain].every((value) => value === 0)).toBe(true);
    expect([...why.verdict].some((verdict) => VERDICTS[verdict] === 'legal')).toBe(true);
  });

  it('are refused with a sentence if they do not fit the mesh', () => {
    const constraints = { locked: new Uint8Array(3) };
    expect(() => floorOf({ ...limber, constraints })).toThrow(
      /^The list of locked vertices has 3 values, but the mesh has \d+ vertices: make it for this mesh\.$/,
    );
    expect(() => floorOf({ ...limber, method: 'other' as 'qem' })).toThrow(/There is no method "other"/);
  });
});
