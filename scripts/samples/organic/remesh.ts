// Isotropic remeshing on an implicit surface: splits long edges, collapses short ones, flips edges to even out valences,
// moves vertices tangentially to the middle of their neighbours and projects them back.

import { cross, dot, length, subtract, type Point } from '../shape';
import { EditableMesh } from './editable-mesh';
import type { Field } from './field';
import type { Net } from './marching-tetrahedra';

export interface RemeshOptions {
  /** Target edge length, metres. */
  edge: number;
  rounds: number;
}

/** A mesh of the same surface and topology with edges of similar length and angles near 60 degrees. */
export function remesh(net: Net, field: Field, { edge, rounds }: RemeshOptions): Net {
  let result = net;
  for (let round = 0; round < rounds; round++) {
    const mesh = new EditableMesh(result);
    splitLong(mesh, (4 / 3) * edge);
    collapseShort(mesh, (4 / 5) * edge, (4 / 3) * edge);
    evenValences(mesh);
    for (let pass = 0; pass < 3; pass++) relax(mesh, field);
    result = mesh.net();
  }
  return result;
}

const middle = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
const distance = (a: Point, b: Point) => length(subtract(a, b));

function splitLong(mesh: EditableMesh, longest: number): void {
  for (const [a, b] of mesh.edges()) {
    const [p, q] = [mesh.point(a), mesh.point(b)];
    if (distance(p, q) > longest) mesh.split(a, b, middle(p, q));
  }
}

function collapseShort(mesh: EditableMesh, shortest: number, longest: number): void {
  for (const [a, b] of mesh.edges()) {
    if (!mesh.isEdge(a, b)) continue; // an earlier collapse removed it
    const [p, q] = [mesh.point(a), mesh.point(b)];
    if (distance(p, q) >= shortest || !mesh.canCollapse(a, b)) continue;
    const target = middle(p, q);
    const around = [...mesh.neighbours(a), ...mesh.neighbours(b)];
    const staysShort = around.every((v) => distance(mesh.point(v), target) <= longest);
    if (staysShort && mesh.keepsNormals(a, target, b) && mesh.keepsNormals(b, target, a))
      mesh.collapse(a, b, target);
  }
}

function evenValences(mesh: EditableMesh): void {
  const excess = (v: number, change: number) => (mesh.valence(v) + change - 6) ** 2;
  for (const [a, b] of mesh.edges()) {
    if (!mesh.isEdge(a, b)) continue;
    const [c, d] = mesh.opposite(a, b);
    const before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    if (after < before && !mesh.isEdge(c, d) && flipStaysFlat(mesh, [a, b, c, d])) mesh.flip(a, b);
  }
}

/** Whether the two faces after a flip have normals similar to those before. */
function flipStaysFlat(mesh: EditableMesh, [a, b, c, d]: number[]): boolean {
  const normal = (i: number, j: number, k: number) => {
    const [p, q, r] = [mesh.point(i), mesh.point(j), mesh.point(k)];
    return cross(subtract(q, p), subtract(r, p));
  };
  const before = [normal(a, b, c), normal(b, a, d)];
  const after = [normal(c, d, b), normal(d, c, a)];
  return before.every((old) => after.every((fresh) => dot(old, fresh) > 0.5 * length(old) * length(fresh)));
}

/** Moves every vertex within its tangent plane to the middle of its neighbours, then back onto the surface. */
function relax(mesh: EditableMesh, field: Field): void {
  for (let v = 0; v < mesh.vertexCount; v++) {
    if (mesh.valence(v) === 0) continue;
    const position = mesh.point(v);
    const { gradient } = field(...position);
    const toCentre = subtract(centroid(mesh.neighbours(v).map((other) => mesh.point(other))), position);
    const lift = dot(toCentre, gradient) / dot(gradient, gradient);
    const slid = (axis: number) => position[axis] + toCentre[axis] - lift * gradient[axis];
    const target = ontoSurface(field, [slid(0), slid(1), slid(2)]);
    if (mesh.keepsNormals(v, target)) mesh.move(v, target);
  }
}

function centroid(points: readonly Point[]): Point {
  const mean = (axis: number) => points.reduce((sum, point) => sum + point[axis], 0) / points.length;
  return [mean(0), mean(1), mean(2)];
}

/** Projects a point onto the surface by Newton steps along the gradient. */
function ontoSurface(field: Field, start: Point): Point {
  let [x, y, z] = start;
  for (let step = 0; step < 2; step++) {
    const { value, gradient } = field(x, y, z);
    const back = value / dot(gradient, gradient);
    [x, y, z] = [x - back * gradient[0], y - back * gradient[1], z - back * gradient[2]];
  }
  return [x, y, z];
}
