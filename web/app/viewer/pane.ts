/** One body of the viewport in a scene of its own. */

import { vertexCount } from '../../engine/core/mesh';
import * as THREE from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import type { Levels } from '../../engine/settings/paint_text';
import { BrushRing } from './brush_ring';
import { geometryFrom, setDisplacement, setField, setPaint } from './body_geometry';
import type { Field } from './body_geometry';
import { CollisionSceneView } from './collision_scene_view';
import type { MapName } from './colours';
import { Dots } from './dots';
import { drawnArrays } from './drawn_arrays';
import type { DrawnArrays } from './drawn_arrays';
import { isPreparedAtOnce, prepareExactly, prepareQuickly } from './prepared_arrays';
import type { SeenBody } from './seen_vertices';
import { Stand } from './stand';
import { HATCH_PIXELS, surfaceMaterial } from './surface_material';
import { isLarge, writePositions, writeValues } from './twin_surface';

/** Opacity of an overlay. */
const OVERLAY_OPACITY = 0.4;

export interface Look {
  clay: string;
  wire: string;
  wireStrength: number;
  /** whether triangles are flat-shaded */
  isFlat?: boolean;
  map: MapName;
}

/** ms for which a mesh must stay unchanged before its exact normals are computed. */
const REST_MILLISECONDS = 250;

/** The positions of the vertices of a moving mesh, and the values that colour them; see `setPositions`. */
interface Moved {
  mesh: TriangleMesh;
  positions: Float32Array;
  values: Float32Array | null;
}

/** The field and displacement with which a mesh is shown. */
interface Appearance {
  field: Field | null;
  shape: Float32Array | null;
}

export class Pane {
  readonly scene = new THREE.Scene();
  /** at the pinned vertices */
  readonly dots: Dots;
  /** at the vertex under the pointer */
  readonly hoverDot: Dots;
  readonly ring = new BrushRing();
  readonly collisionScene = new CollisionSceneView();
  readonly stand = new Stand();
  /** the mesh that is drawn */
  mesh: TriangleMesh | null = null;
  private readonly appearances = new WeakMap<TriangleMesh, Appearance>();
  private asked: TriangleMesh | null = null;
  private preparing: Promise<void> | null = null;
  private readonly body: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private groups: Uint32Array = new Uint32Array();
  private moved: Moved | null = null;
  private isMoved = false;
  private isQuick = false;
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  private areWiresHidden = false;
  private overlayColour: string | null = null;
  private field: Field | null = null;
  private shape: Float32Array | null = null;
  private amplitude = 0;
  private levels: Levels | null = null;
  private isPaintStale = false;
  private isFileShown = false;
  private isFlat = false;

  /** `onRefine`: called when the drawing has changed without a request */
  constructor(
    map: THREE.DataTexture,
    pixelRatio: number,
    private readonly onRefine: () => void,
  ) {
    this.dots = new Dots(pixelRatio);
    this.hoverDot = new Dots(pixelRatio);
    const look = { clay: new THREE.Color(), wire: new THREE.Color(), wireStrength: 0 };
    this.body = new THREE.Mesh(new THREE.BufferGeometry(), surfaceMaterial(map, look));
    this.body.frustumCulled = false; // a swinging body leaves the bounds of its rest pose
    this.body.visible = false;
    this.scene.add(this.body, this.dots.points, this.hoverDot.points, this.collisionScene.group);
    this.scene.add(this.stand.group, this.ring.line);
  }

  /** Shows a mesh; a large one later, when the returned promise resolves, unless another one is requested meanwhile. */
  show(mesh: TriangleMesh | null): Promise<void> | null {
    this.asked = mesh;
    this.remember();
    if (!mesh || isPreparedAtOnce(mesh)) {
      this.put(mesh, mesh && drawnArrays(mesh));
      return null;
    }
    return (this.preparing ??= this.prepare().finally(() => (this.preparing = null)));
  }

  /** Field and shape belong to the mesh that was requested when they arrived, and wait for it. */
  private remember(): void {
    if (this.asked) this.appearances.set(this.asked, { field: this.field, shape: this.shape });
  }

  private appearance(): Appearance | null {
    return (this.mesh && this.appearances.get(this.mesh)) ?? null;
  }

  /** Whether a requested mesh is not yet shown. */
  get isLate(): boolean {
    return this.asked !== this.mesh;
  }

  /** Prepares one mesh at a time, then the latest requested one. */
  private async prepare(): Promise<void> {
    while (this.asked && this.isLate) {
      const mesh = this.asked;
      const drawn = await prepareQuickly(mesh).catch(() => drawnArrays(mesh));
      // While the slider moves, an intermediate mesh is better than none.
      if (this.asked !== null) this.put(mesh, drawn);
    }
  }

  /** Computes exact normals once the mesh has not changed for a while. */
  private refineLater(mesh: TriangleMesh): void {
    this.restTimer = setTimeout(() => {
      void prepareExactly(mesh)
        .catch(() => drawnArrays(mesh))
        .then(({ normals, groups }) => this.refine(mesh, normals, groups));
    }, REST_MILLISECONDS);
  }

  private refine(mesh: TriangleMesh, normals: Float32Array | null, groups: Uint32Array): void {
    if (mesh !== this.mesh || !this.isQuick || !normals) return;
    this.isQuick = false;
    this.groups = groups;
    (this.body.geometry.getAttribute('normal') as THREE.BufferAttribute).copyArray(normals).needsUpdate =
      true;
    this.applyPositions();
    this.onRefine();
  }

  private put(mesh: TriangleMesh | null, drawn: DrawnArrays | null): void {
    this.body.geometry.dispose();
    this.mesh = mesh;
    this.showBody();
    this.body.geometry = mesh && drawn ? geometryFrom(drawn, mesh) : new THREE.BufferGeometry();
    this.groups = drawn?.groups ?? new Uint32Array();
    this.isMoved = false;
    this.isQuick = drawn?.isQuick ?? false;
    clearTimeout(this.restTimer);
    if (mesh && this.isQuick) this.refineLater(mesh);
    this.body.material.uniforms.isFlat.value = this.isFlat || isLarge(mesh);
    this.applyField();
    this.applyShape();
    this.applyPositions();
    this.isPaintStale = true;
  }

  /** Whether the whole file is drawn instead of just the body, once it is loaded. */
  showFile(isShown: boolean): void {
    this.isFileShown = isShown;
    this.showBody();
  }

  /** Whether the file is currently drawn. */
  get showsFile(): boolean {
    return this.isFileShown && this.stand.model !== null;
  }

  showBody(): void {
    this.body.visible = this.mesh !== null && !this.showsFile;
    this.stand.drawFile(this.showsFile);
  }

  /** Mesh, field and shape arrive in any order: a field or shape that does not fit the mesh waits for its own mesh. */
  private applyField(): void {
    const { mesh } = this;
    const field = this.appearance()?.field ?? null;
    const size = field?.on === 'vertices' ? mesh?.positions.length : mesh?.triangles.length;
    const fits = field !== null && size === 3 * field.values.length;
    if (mesh) setField(this.body.geometry, mesh, fits ? field : null);
    this.body.material.uniforms.hasField.value = fits;
  }

  private applyShape(): void {
    if (this.mesh) setDisplacement(this.body.geometry, this.mesh, this.fittingShape());
  }

  private fittingShape(): Float32Array | null {
    const shape = this.appearance()?.shape ?? null;
    return shape?.length === this.mesh?.positions.length ? shape : null;
  }

  colour(field: Field | null, map: THREE.DataTexture): void {
    const isSame = field?.values === this.field?.values && field?.on === this.field?.on;
    this.field = field;
    this.remember();
    if (!isSame) this.applyField();
    this.body.material.uniforms.map.value = map;
  }

  displace(shape: Float32Array | null): void {
    if (shape === this.shape) return;
    this.shape = shape;
    this.remember();
    this.applyShape();
  }

  paint(levels: Levels | null): void {
    this.levels = levels;
    this.isPaintStale = true;
  }

  /** Pixels of the canvas per CSS pixel, for elements of fixed screen size. */
  setPixelRatio(ratio: number): void {
    this.dots.setPixelRatio(ratio);
    this.hoverDot.setPixelRatio(ratio);
    this.body.material.uniforms.hatchPixels.value = HATCH_PIXELS * ratio;
  }

  /** Runs once a frame, because strokes may arrive more often. */
  private applyPaint(): void {
    const { mesh, levels } = this;
    if (mesh && this.isPaintStale)
      setPaint(this.body.geometry, mesh, levels?.length === vertexCount(mesh) ? levels : null);
    this.isPaintStale = false;
  }

  /**
   * Moves the vertices of the requested mesh, once it is shown, or returns them to rest (null); `values[v]` in [0, 1]
   * colour the body.
   */
  setPositions(positions: Float32Array | null, values: Float32Array | null): void {
    const { asked: mesh } = this;
    if (positions && positions.length !== mesh?.positions.length) return;
    this.moved = mesh && positions && { mesh, positions, values };
    this.applyPositions();
  }

  private applyPositions(): void {
    const { mesh, groups, moved } = this;
    // Normals are updated in groups, which come with the exact ones.
    if (!mesh || this.isQuick || (moved ? moved.mesh !== mesh : !this.isMoved)) return;
    this.isMoved = moved !== null;
    const { hasField } = this.body.material.uniforms;
    writePositions(this.body.geometry, mesh, moved?.positions ?? mesh.positions, groups);
    if (!moved) return this.applyField();
    const { values } = moved;
    hasField.value = values?.length === vertexCount(mesh);
    if (values && hasField.value) writeValues(this.body.geometry, mesh, values);
  }

  /** Draws the body translucent in this colour, as an overlay of another body; null: opaque in its own colours. */
  overlay(colour: string | null): void {
    const { material } = this.body;
    material.transparent = colour !== null;
    material.uniforms.opacity.value = colour === null ? 1 : OVERLAY_OPACITY;
    this.overlayColour = colour;
    // The pane below shows the collision scene already.
    this.collisionScene.group.visible = colour === null;
  }

  /** Only draws the depth of the body, so that an overlay shows just the front surface. */
  drawDepth(draw: () => void): void {
    const { material } = this.body;
    this.collisionScene.group.visible = this.dots.points.visible = this.stand.group.visible = false;
    material.colorWrite = false;
    draw();
    material.colorWrite = true;
    this.stand.group.visible = true;
  }

  /** The wireframe of a body below an overlay would make that of the overlay illegible. */
  hideWires(areHidden: boolean): void {
    this.areWiresHidden = areHidden;
  }

  look({ clay, wire, wireStrength, isFlat = false }: Look): void {
    this.isFlat = isFlat;
    const { uniforms } = this.body.material;
    uniforms.clay.value.set(this.overlayColour ?? clay);
    uniforms.wire.value.set(wire);
    uniforms.isFlat.value = isFlat || isLarge(this.mesh);
    uniforms.wireStrength.value = this.areWiresHidden ? 0 : wireStrength;
  }

  swing(amplitude: number): void {
    this.applyPaint();
    this.amplitude = amplitude;
    this.hoverDot.swing(amplitude);
    this.body.material.uniforms.amplitude.value = amplitude;
  }

  /** Marks a vertex, also during motion; null removes the mark. */
  mark(vertex: number | null): void {
    const shape = this.fittingShape();
    if (vertex === null || !this.mesh) return this.hoverDot.setPoints(new Float32Array());
    const at = (values: Float32Array) => values.slice(3 * vertex, 3 * vertex + 3);
    this.hoverDot.setPoints(at(this.mesh.positions), shape && at(shape));
  }

  /** The current positions of the vertices; see `nearestSeen`. */
  seen(): SeenBody | null {
    const { mesh, amplitude } = this;
    return mesh && { positions: mesh.positions, shape: this.fittingShape(), amplitude };
  }
}
