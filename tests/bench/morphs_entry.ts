// The entry of the bundle of morphs.mjs: bodies with bumps as morph targets, and how far their results are from them.

import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { exportGlb } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import type { OpenModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { FileRun } from '../../web/engine/stages/file_run';
import { STAGES } from '../../web/engine/stages/stages';

export { loadCore } from '../../web/engine/core/load_core';

/** Height and radius of a bump, in shares of the diagonal. */
const [HEIGHT, RADIUS] = [0.05, 0.06];
/** Sampled points of each surface. */
const SAMPLES = 20_000;

export interface Bumps {
  count: number;
  /** centres lie evenly among the first vertices of the file, this share of all */
  share: number;
}

export interface Distances {
  faces: number;
  /** of the rest shapes, mean, % of the diagonal */
  rest: number;
  /** with one target at full weight, the largest distance, % of the diagonal, in the mean over the targets */
  largest: number;
}

/** Results at a share of the faces: of the body with targets that are ignored, and with targets that count. */
export async function measureMorphs(
  core: Core,
  obj: Uint8Array,
  { bumps, ratio }: { bumps: Bumps; ratio: number },
) {
  const plain = await asGlb(await openModel([{ name: 'a.obj', bytes: obj }]));
  // Targets that move nothing cost nothing, and the result knows for every vertex where it is from.
  const still = await withBumps(plain, bumps, 0);
  const bumpy = await withBumps(plain, bumps, HEIGHT);
  const ignored = await reduced(core, { measured: bumpy, worked: still, ratio });
  const counted = await reduced(core, { measured: bumpy, worked: bumpy, ratio });
  const distances = (result: OpenModel) => compare(core, [bumpy, result], bumps.count);
  return {
    before: bumpy.bodies[0].indices.length / 3,
    ignored: distances(ignored),
    counted: distances(counted),
  };
}

const asGlb = async (model: OpenModel): Promise<OpenModel> =>
  openModel([{ name: 'a.glb', bytes: await exportGlb(model, [null], { fields: false }) }]);

async function withBumps(model: OpenModel, { count, share }: Bumps, height: number): Promise<OpenModel> {
  const copy = await asGlb(model);
  const { document } = copy;
  const [primitive] = document.getRoot().listMeshes()[0].listPrimitives();
  const positions = primitive.getAttribute('POSITION')!.getArray() as Float32Array;
  const diagonal = diagonalOf(positions);
  const [buffer] = document.getRoot().listBuffers();
  for (let k = 0; k < count; ++k) {
    const centre = 3 * Math.floor(((k + 0.5) * share * positions.length) / 3 / count);
    const direction = [Math.sin(2.1 * k), Math.cos(1.3 * k), Math.sin(k + 0.5)];
    const values = positions.map((_, i) => {
      const first = i - (i % 3);
      const away = [0, 1, 2].map((c) => (positions[first + c] - positions[centre + c]) / (RADIUS * diagonal));
      return height * diagonal * direction[i % 3] * Math.exp(-away.reduce((sum, x) => sum + x * x, 0));
    });
    const accessor = document.createAccessor('', buffer).setType('VEC3').setArray(values);
    primitive.addTarget(document.createPrimitiveTarget(`bump ${k}`).setAttribute('POSITION', accessor));
  }
  return asGlb(copy);
}

function diagonalOf(positions: Float32Array): number {
  const sizes = [0, 1, 2].map((c) => {
    const own = positions.filter((_, i) => i % 3 === c);
    return (
      own.reduce((most, x) => Math.max(most, x), -Infinity) -
      own.reduce((least, x) => Math.min(least, x), Infinity)
    );
  });
  return Math.hypot(...sizes);
}

/** `measured` with the result of `worked`, whose body has the same vertices and triangles. */
async function reduced(
  core: Core,
  { measured, worked, ratio }: { measured: OpenModel; worked: OpenModel; ratio: number },
): Promise<OpenModel> {
  const file = new FileRun(core, worked);
  const faces = worked.bodies[0].indices.length / 3;
  const settings = {
    ...defaultSettings(),
    targetFaces: Math.round(ratio * faces),
    maxDeviation: 0,
    fields: false,
  };
  const written = file.runs[0]!.get(STAGES.written, settings as never);
  file.dispose();
  const exported = { ...written, body: measured.bodies[0] };
  return openModel([{ name: 'a.glb', bytes: await exportGlb(measured, [exported], { fields: false }) }]);
}

function compare(core: Core, [original, result]: [OpenModel, OpenModel], count: number): Distances {
  const percent = 100 / diagonalOf(original.bodies[0].positions);
  const between = (target: number | null) =>
    core.measureSurfaceDistance(shapeOf(core, original, target), shapeOf(core, result, target), SAMPLES);
  const targets = Array.from({ length: count }, (_, k) => between(k).hausdorff);
  return {
    faces: result.bodies[0].indices.length / 3,
    rest: percent * between(null).mean,
    largest: (percent * targets.reduce((sum, value) => sum + value, 0)) / count,
  };
}

/** The body at rest, or with one target at full weight. */
function shapeOf(core: Core, { document, bodies: [body] }: OpenModel, target: number | null): TriangleMesh {
  const positions = body.positions.slice();
  const primitives = document.getRoot().listMeshes()[0].listPrimitives();
  for (const { primitive, firstVertex } of target === null ? [] : body.spans) {
    const moves = primitives[primitive].listTargets()[target!].getAttribute('POSITION')!;
    for (let v = 0; v < moves.getCount(); ++v)
      moves.getElement(v, []).forEach((value, c) => (positions[3 * (firstVertex + v) + c] += value));
  }
  return core.weld(positions, body.indices, { tolerance: 0 }).mesh;
}
