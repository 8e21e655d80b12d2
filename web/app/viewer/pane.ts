/** One body of the stage in its own scene. */

import * as THREE from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import type { Levels } from '../../engine/settings/paint_text';
import { bodyGeometry, setDisplacement, setField, setPaint } from './body_geometry';
import type { Field } from './body_geometry';
import type { MapName } from './colours';
import { PinDots } from './pin_dots';
import type { SeenBody } from './seen_vertices';
import { surfaceMaterial } from './surface_material';
import { PropsView } from './twin_props';
import { isLarge, paintSurface, placeSurface } from './twin_surface';

export interface Look {
  clay: string;
  wire: string;
  wireStrength: number;
  map: MapName;
}

/** One body in its own scene. */
export class Pane {
  readonly scene = new THREE.Scene();
  readonly dots: PinDots;
  readonly props = new PropsView();
  private groups: Uint32Array = new Uint32Array();
  private isPlaced = false;
  private isBare = false;
  private veilColour: string | null = null;
  private readonly body: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  mesh: TriangleMesh | null = null;
  private field: Field | null = null;
  private shape: Float32Array | null = null;
  /** at a vertex that is asked about */
  readonly probe: PinDots;
  private amplitude = 0;
  private levels: Levels | null = null;
  private isPaintStale = false;

  constructor(map: THREE.DataTexture, pixelRatio: number) {
    this.dots = new PinDots(pixelRatio);
    this.probe = new PinDots(pixelRatio);
    const look = { clay: new THREE.Color(), wire: new THREE.Color(), wireStrength: 0 };
    this.body = new THREE.Mesh(new THREE.BufferGeometry(), surfaceMaterial(map, look));
    this.body.frustumCulled = false; // a swinging body leaves the bounds of its rest pose
    this.body.visible = false;
    this.scene.add(this.body, this.dots.points, this.probe.points, this.props.group);
  }

  show(mesh: TriangleMesh | null): void {
    this.body.geometry.dispose();
    this.mesh = mesh;
    this.body.visible = mesh !== null;
    const { geometry, groups } = mesh
      ? bodyGeometry(mesh)
      : { geometry: new THREE.BufferGeometry(), groups: new Uint32Array() };
    this.body.geometry = geometry;
    this.groups = groups;
    this.isPlaced = false;
    this.body.material.uniforms.isFlat.value = isLarge(mesh);
    this.applyField();
    this.applyShape();
    this.isPaintStale = true;
  }

  /** Mesh, field and shape may come in any order: what does not fit the mesh yet waits for the one that it belongs to. */
  private applyField(): void {
    const { mesh, field } = this;
    const size = field?.on === 'vertices' ? mesh?.positions.length : mesh?.triangles.length;
    const fits = field !== null && size === 3 * field.values.length;
    if (mesh) setField(this.body.geometry, mesh, fits ? field : null);
    this.body.material.uniforms.hasField.value = fits;
  }

  private applyShape(): void {
    const { mesh, shape } = this;
    if (mesh)
      setDisplacement(this.body.geometry, mesh, shape?.length === mesh.positions.length ? shape : null);
  }

  colour(field: Field | null, map: THREE.DataTexture): void {
    const isSame = field?.values === this.field?.values && field?.on === this.field?.on;
    this.field = field;
    if (!isSame) this.applyField();
    this.body.material.uniforms.map.value = map;
  }

  displace(shape: Float32Array | null): void {
    if (shape === this.shape) return;
    this.shape = shape;
    this.applyShape();
  }

  paint(levels: Levels | null): void {
    this.levels = levels;
    this.isPaintStale = true;
  }

  /** Once a frame, for a hand may paint more often. */
  private applyPaint(): void {
    const { mesh, levels } = this;
    if (mesh && this.isPaintStale)
      setPaint(this.body.geometry, mesh, levels?.length === mesh.positions.length / 3 ? levels : null);
    this.isPaintStale = false;
  }

  /** Vertices elsewhere than at rest, or back there (null), and values in [0, 1] to colour them by. */
  place(positions: Float32Array | null, values: Float32Array | null): void {
    const { mesh, groups } = this;
    if (!mesh || (positions ? positions.length !== mesh.positions.length : !this.isPlaced)) return;
    this.isPlaced = positions !== null;
    const { hasField } = this.body.material.uniforms;
    placeSurface(this.body.geometry, mesh, positions ?? mesh.positions, groups);
    if (!positions) return this.applyField();
    hasField.value = values?.length === mesh.positions.length / 3;
    if (values && hasField.value) paintSurface(this.body.geometry, mesh, values);
  }

  /** As a veil over another body, or as itself (null). */
  veil(colour: string | null): void {
    const { material } = this.body;
    material.transparent = colour !== null;
    material.uniforms.opacity.value = colour === null ? 1 : 0.4;
    this.veilColour = colour;
    // Those of the body below are enough.
    this.props.group.visible = colour === null;
  }

  /** Its depth alone, so that a veil is of one layer. */
  drawDepth(draw: () => void): void {
    const { material } = this.body;
    this.props.group.visible = this.dots.points.visible = false;
    material.colorWrite = false;
    draw();
    material.colorWrite = true;
  }

  /** Without wires: those of the veil over it would drown in them. */
  bare(isBare: boolean): void {
    this.isBare = isBare;
  }

  look({ clay, wire, wireStrength }: Look): void {
    const { uniforms } = this.body.material;
    uniforms.clay.value.set(this.veilColour ?? clay);
    uniforms.wire.value.set(wire);
    uniforms.wireStrength.value = this.isBare ? 0 : wireStrength;
  }

  swing(amplitude: number): void {
    this.applyPaint();
    this.amplitude = amplitude;
    this.probe.swing(amplitude);
    this.body.material.uniforms.amplitude.value = amplitude;
  }

  /** The vertex, as it moves. */
  mark(vertex: number | null): void {
    const shape = this.fittingShape();
    if (vertex === null || !this.mesh) return this.probe.place(new Float32Array());
    const at = (values: Float32Array) => values.slice(3 * vertex, 3 * vertex + 3);
    this.probe.place(at(this.mesh.positions), shape && at(shape));
  }

  private fittingShape(): Float32Array | null {
    return this.shape?.length === this.mesh?.positions.length ? this.shape : null;
  }

  /** Where the vertices are seen now; see `seenVertices`. */
  seen(): SeenBody | null {
    const { mesh, amplitude } = this;
    return mesh && { positions: mesh.positions, shape: this.fittingShape(), amplitude };
  }

  /** Of the bounding box. */
  corners(): THREE.Vector3[] {
    const box = this.mesh && this.body.geometry.boundingBox;
    if (!box) return [];
    const [x, y, z] = (['x', 'y', 'z'] as const).map((axis) => [box.min[axis], box.max[axis]]);
    return x.flatMap((a) => y.flatMap((b) => z.map((c) => new THREE.Vector3(a, b, c))));
  }

  sphere(): THREE.Sphere | null {
    return this.mesh ? this.body.geometry.boundingSphere : null;
  }
}
