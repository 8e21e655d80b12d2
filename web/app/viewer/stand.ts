/** The stand of a body in the scene: the rotation, position and mean scale of its node, a floor below it, and light. */

import * as THREE from 'three';
import type { TriangleMesh } from '../../engine/core/core';
import { rotationOf } from '../../engine/motion/scene_rotation';
import { floorShadow, SHADOW_SIZE } from './floor_shadow';
import type { SceneLook, SceneModel } from './file/scene_model';
import { outermost } from './camera/outermost';
import { spreadPoints } from './spread_points';

/** The floor's shadow extends beyond the body by this fraction of its size. */
const AROUND = 1.9;

/** Everything in the space of the scene, transformed to the space of the shown body. */
export class Stand {
  /** contains the scene; its matrix transforms from the space of the scene to that of the shown body */
  readonly group = new THREE.Group();
  model: SceneModel | null = null;
  private readonly floor: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  private readonly light = new THREE.DirectionalLight('#ffffff', 1.1);

  constructor() {
    this.group.matrixAutoUpdate = false;
    const material = new THREE.MeshBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false });
    this.floor = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), material);
    this.floor.visible = false;
    this.floor.rotation.x = -Math.PI / 2;
    this.light.position.set(-0.6, 1.4, 1);
    this.group.add(this.floor, this.light, this.light.target);
  }

  /** `toMesh`: from the space of the scene to that of the shown body. */
  standAt(toMesh: THREE.Matrix4): void {
    this.group.matrix.copy(toMesh);
    this.group.matrixWorldNeedsUpdate = true;
  }

  /** Shows a file in place of another; null removes it. */
  show(model: SceneModel | null): void {
    if (this.model) this.group.remove(this.model.root);
    this.model?.dispose();
    this.model = model;
    if (model) this.group.add(model.root);
  }

  /** Whether the file is drawn. Its light is always on, because materials are compiled for a number of lights. */
  drawFile(isDrawn: boolean): void {
    if (this.model) this.model.root.visible = isDrawn;
  }

  look(look: SceneLook): void {
    this.model?.look(look);
  }

  /** Puts the floor below the shown file, or below a mesh in the space of the shown body; returns the outermost points of either in the scene. */
  layFloor(mesh: TriangleMesh | null): THREE.Vector3[] {
    const inScene = mesh ? this.toScene(mesh) : this.pointsOfFile();
    const points = outermost(inScene);
    const box = new THREE.Box3().setFromPoints(points);
    this.floor.visible = !box.isEmpty();
    if (box.isEmpty()) return [];
    const size = box.getSize(new THREE.Vector3());
    const centre = box.getCenter(new THREE.Vector3());
    const side = AROUND * Math.max(size.x, size.z, 0.25 * size.y);
    const area = { centre: [centre.x, box.min.y, centre.z] as const, side, top: 0.35 * size.length() };
    this.floor.material.map?.dispose();
    this.floor.material.map = shadowTexture(floorShadow(inScene, area));
    this.floor.material.needsUpdate = true;
    this.floor.position.set(centre.x, box.min.y - 0.001 * size.length(), centre.z);
    this.floor.scale.setScalar(side);
    return points;
  }

  /** Shows the same floor as another stand. */
  shareFloor({ floor }: Stand): void {
    this.floor.material.map = floor.material.map;
    this.floor.material.needsUpdate = true;
    this.floor.position.copy(floor.position);
    this.floor.scale.copy(floor.scale);
  }

  /** Removes the floor until it is placed again. */
  liftFloor(): void {
    this.floor.material.map?.dispose();
    this.floor.material.map = null;
    this.floor.visible = false;
  }

  private pointsOfFile(): Float32Array {
    return this.model?.root.visible ? this.model.points() : new Float32Array();
  }

  set isFloorShown(isShown: boolean) {
    this.floor.visible = isShown && this.floor.material.map !== null;
  }

  private toScene({ positions, triangles }: TriangleMesh): Float32Array {
    const matrix = this.group.matrix.clone().invert();
    const points = spreadPoints(positions, triangles);
    const point = new THREE.Vector3();
    for (let i = 0; i < points.length; i += 3)
      point.fromArray(points, i).applyMatrix4(matrix).toArray(points, i);
    return points;
  }

  dispose(): void {
    this.show(null);
    this.floor.material.map?.dispose();
  }
}

function shadowTexture(shadow: Float32Array): THREE.DataTexture {
  const data = new Uint8Array(4 * shadow.length);
  // The rows of a texture go up; those of the shadow go along z, towards the lower edge of a horizontal plane.
  shadow.forEach((value, i) => {
    const [row, column] = [Math.floor(i / SHADOW_SIZE), i % SHADOW_SIZE];
    const to = (SHADOW_SIZE - 1 - row) * SHADOW_SIZE + column;
    data.set([12, 20, 30, Math.round(255 * value)], 4 * to);
  });
  const texture = new THREE.DataTexture(data, SHADOW_SIZE, SHADOW_SIZE);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** From the space of the scene to that of a body with this placement, without stretching or mirroring. */
export function standingMatrix(nodeMatrix: readonly number[]): THREE.Matrix4 {
  const matrix = new THREE.Matrix4().fromArray([...nodeMatrix]);
  const scale = Math.cbrt(Math.abs(matrix.determinant())) || 1;
  const position = new THREE.Vector3().setFromMatrixPosition(matrix);
  if (!Number.isFinite(scale + position.length())) return new THREE.Matrix4();
  const rows = rotationOf(nodeMatrix) ?? [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const rotation = new THREE.Matrix4().setFromMatrix3(new THREE.Matrix3().fromArray([...rows]).transpose());
  const quaternion = new THREE.Quaternion().setFromRotationMatrix(rotation);
  return new THREE.Matrix4().compose(position, quaternion, new THREE.Vector3(scale, scale, scale)).invert();
}

/** From the space of the scene to that of a body with this placement. */
export const standingRotation = (nodeMatrix: readonly number[]): THREE.Quaternion =>
  new THREE.Quaternion().setFromRotationMatrix(
    new THREE.Matrix4().extractRotation(standingMatrix(nodeMatrix)),
  );
