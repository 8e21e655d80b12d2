/** Pictures of several meshes from one viewpoint: one shared renderer draws them in turn and copies each to its own canvas. */

import * as THREE from 'three';
import type { TriangleMesh } from '../../../engine/core/core';
import { geometryFrom } from '../body_geometry';
import { mapTexture } from '../colours';
import { drawnArrays } from '../drawn_arrays';
import { isPreparedAtOnce, prepareExactly } from '../prepared_arrays';
import { surfaceMaterial } from '../surface_material';
import { isLarge } from '../twin_surface';

export const METHOD_PICTURE = { width: 320, height: 240 };
/** The distance of the camera, in radii. */
const DISTANCE = 4.1;
const MAX_POLAR = 1.5;

export interface PictureLook {
  clay: string;
  wire: string;
  wireStrength: number;
}

interface Drawn {
  canvas: HTMLCanvasElement;
  geometry: THREE.BufferGeometry;
  isFlat: boolean;
}

export class MethodPictures {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera: THREE.PerspectiveCamera;
  private readonly body: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private readonly drawn = new Map<TriangleMesh, Drawn>();
  private sphere: THREE.Sphere | null = null;
  private azimuth = 0.64;
  private polar = 0.32;
  private due = 0;
  private isDisposed = false;

  /** `rotation`: from the space of the scene to that of the meshes. Throws if WebGL2 is missing. */
  constructor(private readonly rotation: THREE.Quaternion) {
    const { width, height } = METHOD_PICTURE;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera = new THREE.PerspectiveCamera(30, width / height, 0.01, 100);
    const look = { clay: new THREE.Color(), wire: new THREE.Color(), wireStrength: 0 };
    this.body = new THREE.Mesh(new THREE.BufferGeometry(), surfaceMaterial(mapTexture('viridis'), look));
    this.body.frustumCulled = false;
    this.scene.add(this.body);
  }

  /** Draws a mesh on a canvas from now on, a large one later. The first mesh determines where the camera looks. */
  async show(mesh: TriangleMesh, canvas: HTMLCanvasElement): Promise<void> {
    const known = this.drawn.get(mesh);
    if (known?.canvas === canvas) return;
    const arrays = isPreparedAtOnce(mesh)
      ? drawnArrays(mesh)
      : await prepareExactly(mesh).catch(() => drawnArrays(mesh));
    if (this.isDisposed) return;
    const geometry = geometryFrom(arrays, mesh);
    this.sphere ??= geometry.boundingSphere!.clone();
    this.forget(mesh, canvas);
    this.drawn.set(mesh, { canvas, geometry, isFlat: isLarge(mesh) });
    this.drawSoon();
  }

  /** Releases the drawing of this mesh, and of another one on the same canvas. */
  private forget(mesh: TriangleMesh, canvas: HTMLCanvasElement): void {
    for (const [other, drawn] of this.drawn) {
      if (other !== mesh && drawn.canvas !== canvas) continue;
      drawn.geometry.dispose();
      this.drawn.delete(other);
    }
  }

  look({ clay, wire, wireStrength }: PictureLook): void {
    const { uniforms } = this.body.material;
    uniforms.clay.value.set(clay);
    uniforms.wire.value.set(wire);
    uniforms.wireStrength.value = wireStrength;
    this.drawSoon();
  }

  /** Rotates the camera around all meshes, in radians. */
  rotate(azimuth: number, polar: number): void {
    this.azimuth += azimuth;
    this.polar = Math.max(-MAX_POLAR, Math.min(MAX_POLAR, this.polar + polar));
    this.drawSoon();
  }

  dispose(): void {
    this.isDisposed = true;
    cancelAnimationFrame(this.due);
    for (const { geometry } of this.drawn.values()) geometry.dispose();
    this.body.material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private drawSoon(): void {
    cancelAnimationFrame(this.due);
    this.due = requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    if (!this.sphere) return;
    this.aim(this.sphere);
    for (const { canvas, geometry, isFlat } of this.drawn.values()) {
      const context = canvas.getContext('2d');
      if (!context) continue;
      this.body.geometry = geometry;
      this.body.material.uniforms.isFlat.value = isFlat;
      this.renderer.render(this.scene, this.camera);
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.drawImage(this.renderer.domElement, 0, 0, canvas.width, canvas.height);
    }
  }

  private aim({ center, radius }: THREE.Sphere): void {
    const { camera, azimuth, polar } = this;
    const eye = new THREE.Vector3(
      Math.cos(polar) * Math.sin(azimuth),
      Math.sin(polar),
      Math.cos(polar) * Math.cos(azimuth),
    );
    camera.position.copy(center).add(eye.multiplyScalar(DISTANCE * radius).applyQuaternion(this.rotation));
    camera.near = radius / 50;
    camera.far = radius * 50;
    camera.up.set(0, 1, 0).applyQuaternion(this.rotation);
    camera.lookAt(center);
    camera.updateProjectionMatrix();
  }
}
