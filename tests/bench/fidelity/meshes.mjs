// The meshes of the evaluation: the welded largest components of the samples and of meshes in ../shared/meshes.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { largestComponent, readObj } from '../bench_meshes.mjs';
import { hashOf, root } from './load_engine.mjs';

export const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');

/**
 * `kind` decides the target of the mean smallest angle: organic, cloth, or hard (edges and struts: no target). A mesh
 * with `sample` comes from scripts/samples, the others from their `file`. `large` meshes need --all; `quick` meshes are
 * those of the quick table.
 */
export const MESHES = [
  { name: 'bar', sample: 'bar', kind: 'hard', quick: true },
  { name: 'hanging cloth', sample: 'cloth', kind: 'cloth', quick: true },
  { name: 'tower', sample: 'tower', kind: 'hard' },
  { name: 'organic', sample: 'organic', kind: 'organic', quick: true },
  { name: 'spot', file: 'spot_uv.obj', kind: 'organic', quick: true },
  { name: 'goathead', file: 'goathead.obj', kind: 'organic' },
  { name: 'bob', file: 'bob_genus1.obj', kind: 'organic' },
  { name: 'blub', file: 'blub_fish.obj', kind: 'organic' },
  { name: 'torus', file: 'torus_4608.obj', kind: 'organic' },
  { name: 'cloth grid', file: 'derived_cloth_grid_3200.obj', kind: 'cloth' },
  { name: 'skirt', file: 'skirt_4k.obj', kind: 'cloth', quick: true },
  { name: 'ribbon', file: 'ribbon_1.6k.obj', kind: 'cloth' },
  { name: 'bowl', file: 'bowl_thin_shell.obj', kind: 'cloth' },
  { name: 'letter', file: 'font_tao.obj', kind: 'hard' },
  { name: 'airplane', file: 'airplane_holes_open.obj', kind: 'hard' },
  { name: 'eiffel', file: 'derived_eiffel_6156.obj', kind: 'hard', quick: true },
  { name: 'pyramid frame', file: 'pyramid_frame_genus4.obj', kind: 'hard' },
  { name: 'cad part', file: 'featuretype_cad.obj', kind: 'hard' },
  { name: 'tablecloth', file: 'tablecloth.obj', kind: 'cloth', large: true },
  { name: 'sword', file: 'sword_quad_dominant.obj', kind: 'hard', large: true },
  { name: 'mountain', file: 'mountain_open_sheet.obj', kind: 'hard', large: true },
  { name: 'hammer', file: 'hammer_60k.obj', kind: 'hard', large: true },
  { name: 'nefertiti', file: 'nefertiti_lowres.obj', kind: 'organic', large: true },
  { name: 'scorpion', file: 'scorpion_100k.obj', kind: 'organic', large: true },
  { name: 'skull', file: 'skull_100k_highgenus.obj', kind: 'organic', large: true },
];

/** Meshes in ../shared/meshes that are not used, and why. */
export const LEFT_OUT = [
  ['blub_fish_quads, spot_quads_control, cube_no_bottom, boxNotManifold', 'fewer than 1,000 faces'],
  ['openscad_nonmanifold_crash, dirty/*', 'not manifold or degenerate: shells on them are not defined'],
  ['derived_rectangle_8x8x24_1792', 'the sample "bar" again'],
  ['pirate', 'twelve small parts, none with 1,000 faces'],
  ['spot_textured/*, gltf/*', 'the same shapes in other formats, or fewer than 1,000 faces'],
];

/**
 * The chosen meshes, prepared: { name, kind, prepared, hash }. `names` selects by beginnings of names, otherwise
 * `isWanted` decides. Absent files are pushed to `missing`.
 */
export function loadMeshes({ engine, core }, { names, isWanted, missing }) {
  const chosen = MESHES.filter((mesh) =>
    names ? names.some((name) => mesh.name.startsWith(name)) : isWanted(mesh),
  );
  if (chosen.length === 0) throw new Error(`No mesh is called ${names}: see MESHES in meshes.mjs.`);
  return chosen.flatMap((mesh) => {
    if (mesh.file && !existsSync(join(shared, mesh.file))) {
      missing.push(`mesh ${mesh.file} of ../shared/meshes`);
      return [];
    }
    return [{ ...mesh, ...prepare({ engine, core }, mesh) }];
  });
}

function prepare({ engine, core }, { name, sample, file }) {
  const source = file ? readObj(join(shared, file)) : engine.samples.find(({ id }) => id === sample).make();
  const welded = core.weld(source.positions, source.triangles, { tolerance: 0 }).mesh;
  const { positions, triangles } = largestComponent(welded);
  const body = { name, positions, indices: triangles, notes: [], mesh: 0, spans: [], scale: 1 };
  const prepared = engine.prepareBody(core, body, engine.defaultSettings());
  if (prepared.inspection.nonManifoldEdges + prepared.inspection.nonManifoldVertices > 0)
    throw new Error(`The mesh "${name}" is not manifold: take it out of MESHES.`);
  return { prepared, faces: triangles.length / 3, hash: hashOf(positions, triangles) };
}
