/** Animated pictures of modes: one shared renderer draws them in turn and copies each to its own small canvas. */

import { faceCount } from '../../../engine/core/mesh';
import * as THREE from 'three';
import type { TriangleMesh } from '../../../engine/core/core';
import { geometryFrom, setDisplacement, setField } from '../body_geometry';
import { mapTexture } from '../colours';
import { drawnArrays } from '../drawn_arrays';
import type { DrawnArrays } from '../drawn_arrays';
import { isPreparedAtOnce, prepareExactly } from '../prepared_arrays';
import { surfaceMaterial } from '../surface_material';
import { isLarge } from '../twin_surface';
import { frameSwing } from './frame_swing';

export const THUMBNAIL = { width: 148, height: 104 };
/** Larger meshes stand still, so that the gallery never slows down the page. */
const MAX_MOVING_FACES = 40000;
const FRAME_MILLISECONDS = 50;
/** Of the radius: large enough that modes can be distinguished at this size. */
const AMPLITUDE = 0.32;

type Attribute = THREE.BufferAttribute | THREE.InterleavedBufferAttribute;

/** One mode: `shape[3 v + c]`, with largest displacement 1, and the strain of each triangle, 0..255. */
export interface ShownMode {
  shape: Float32Array;
  strain: Uint8Array;
}

interface Picture {
  canvas: HTMLCanvasElement;
  displacement: Attribute;
  /** the field that colours it */
  value: Attribute;
}

interface ShownGallery {
  mesh: TriangleMesh;
  modes: ShownMode[];
  /** one per mode */
  canvases: HTMLCanvasElement[];
}

export class Thumbnails {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(30, THUMBNAIL.width / THUMBNAIL.height, 0.01, 100);
  private readonly body: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private pictures: Picture[] = [];
  private lastDrawn = 0;
  /** counts calls of `show`: only the latest is shown */
  private requests = 0;
  private amplitude = 0;
  private faces = 0;
  private isMoving = true;

  constructor() {
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(THUMBNAIL.width, THUMBNAIL.height, false);
    const look = { clay: new THREE.Color('#8fa6b8'), wire: new THREE.Color(), wireStrength: 0 };
    this.body = new THREE.Mesh(new THREE.BufferGeometry(), surfaceMaterial(mapTexture('viridis'), look));
    this.body.frustumCulled = false;
    this.scene.add(this.body);
    this.renderer.setAnimationLoop((time) => this.frame(time));
  }

  /** Shows one mode per canvas, of a large mesh later; `turn`: from the space of the scene to that of the mesh. */
  show(gallery: ShownGallery, rotation: THREE.Quaternion): void {
    const request = ++this.requests;
    const { mesh } = gallery;
    if (isPreparedAtOnce(mesh)) return this.put(gallery, drawnArrays(mesh), rotation);
    void prepareExactly(mesh)
      .catch(() => drawnArrays(mesh))
      .then((drawn) => {
        if (request === this.requests) this.put(gallery, drawn, rotation);
      });
  }

  /** All modes are shown at one scale, as large as possible without swinging out of the picture. */
  private put({ mesh, modes, canvases }: ShownGallery, drawn: DrawnArrays, rotation: THREE.Quaternion): void {
    this.forgetPictures();
    const geometry = (this.body.geometry = geometryFrom(drawn, mesh));
    this.body.material.uniforms.isFlat.value = isLarge(mesh);
    this.faces = faceCount(mesh);
    this.body.material.uniforms.hasField.value = true;
    const { radius } = geometry.boundingSphere!;
    this.amplitude = AMPLITUDE * radius;
    this.camera.up.set(0, 1, 0).applyQuaternion(rotation);
    const swing = {
      positions: mesh.positions,
      shapes: modes.map((mode) => mode.shape),
      amplitude: this.amplitude,
    };
    frameSwing(this.camera, radius, new THREE.Vector3(0.75, 0.42, 1).applyQuaternion(rotation), swing);
    if (this.faces > MAX_MOVING_FACES) return void this.drawOnce(mesh, modes, canvases);
    this.pictures = modes.map((mode, i) => ({ canvas: canvases[i], ...this.dress(mesh, mode) }));
    this.draw(0);
  }

  /** Applies the shape and the colours of a mode to the body. */
  private dress(mesh: TriangleMesh, { shape, strain }: ShownMode): Omit<Picture, 'canvas'> {
    const { geometry } = this.body;
    setDisplacement(geometry, mesh, shape);
    const values = new Float32Array(strain.length);
    for (let t = 0; t < strain.length; t++) values[t] = strain[t] / 255;
    setField(geometry, mesh, { on: 'triangles', values });
    return { displacement: geometry.getAttribute('displacement'), value: geometry.getAttribute('value') };
  }

  /** Draws a large mesh at full swing, one mode between two frames, without keeping its data. */
  private async drawOnce(
    mesh: TriangleMesh,
    modes: readonly ShownMode[],
    canvases: readonly HTMLCanvasElement[],
  ): Promise<void> {
    const request = this.requests;
    this.pictures = [];
    for (const [i, mode] of modes.entries()) {
      await new Promise((resolve) => setTimeout(resolve));
      if (request !== this.requests) return;
      const { displacement, value } = this.dress(mesh, mode);
      this.body.material.uniforms.amplitude.value = this.amplitude;
      this.drawOn({ canvas: canvases[i], displacement, value });
      // Frees its memory on the graphics card.
      this.body.geometry.dispose();
    }
    this.body.geometry = new THREE.BufferGeometry();
  }

  /** Animates the pictures, or freezes them at full swing. */
  move(isMoving: boolean): void {
    this.isMoving = isMoving;
    this.draw(this.lastDrawn);
  }

  dispose(): void {
    this.requests++;
    this.renderer.setAnimationLoop(null);
    this.forgetPictures();
    this.renderer.dispose();
  }

  /** Frees the memory of the pictures on the graphics card: a geometry only knows the attributes with which it was last drawn. */
  private forgetPictures(): void {
    for (const { displacement, value } of this.pictures) {
      this.body.geometry.setAttribute('displacement', displacement);
      this.body.geometry.setAttribute('value', value);
      this.body.geometry.dispose();
    }
    this.body.geometry.dispose();
    this.pictures = [];
  }

  private frame(time: number): void {
    if (!this.isMoving || this.faces > MAX_MOVING_FACES) return;
    if (time - this.lastDrawn < FRAME_MILLISECONDS) return;
    this.draw(time);
  }

  private draw(time: number): void {
    this.lastDrawn = time;
    const swing = this.isMoving ? Math.sin(time / 450) : 1;
    this.body.material.uniforms.amplitude.value = this.amplitude * swing;
    for (const picture of this.pictures) this.drawOn(picture);
  }

  private drawOn({ canvas, displacement, value }: Picture): void {
    this.body.geometry.setAttribute('displacement', displacement);
    this.body.geometry.setAttribute('value', value);
    this.renderer.render(this.scene, this.camera);
    const context = canvas.getContext('2d');
    if (!context) return;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(this.renderer.domElement, 0, 0, canvas.width, canvas.height);
  }
}
