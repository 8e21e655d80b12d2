/** Draws one level of detail at the size that it has on a screen. */

import * as THREE from 'three';
import { lightByRoom } from '../../viewer/room_light';
import { SceneModel } from '../../viewer/file/scene_model';
import type { SceneLook } from '../../viewer/file/scene_model';

const FIELD_OF_VIEW = 30;
/** The share of the picture that a level fills when drawn large. */
const FILLED = 0.94;

const look: SceneLook = {
  name: 'textured',
  isFlat: false,
  clay: '#c3b8ab',
  wire: '#000000',
  wireStrength: 0,
  shown: null,
};

export class LevelView {
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly turned = new THREE.Group();
  private readonly camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
  private models: SceneModel[] = [];
  private centre = new THREE.Vector3();
  private radius = 1;

  /** Throws without WebGL2. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    const key = new THREE.DirectionalLight('#ffffff', 1.1);
    key.position.set(-1, 2, 1.5);
    this.turned.rotation.y = -0.6;
    this.scene.add(this.turned, key);
  }

  /** `files`: a GLB for each level, the first one first. */
  async load(files: readonly Uint8Array[]): Promise<void> {
    const [models] = await Promise.all([
      Promise.all(files.map((bytes) => SceneModel.load(bytes))),
      lightByRoom(this.scene),
    ]);
    for (const model of models) model.look(look);
    for (const model of this.models) model.dispose();
    this.models = models;
    const box = new THREE.Box3().setFromObject(models[0].root);
    box.getCenter(this.centre);
    this.radius = Math.max(box.getSize(new THREE.Vector3()).length() / 2, 1e-9);
  }

  /** Draws level `number`; `height`: CSS pixels of its diagonal, null to fill the picture. */
  draw(number: number, height: number | null): void {
    const model = this.models[number];
    if (!model) return;
    const { clientWidth, clientHeight } = this.canvas;
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.turned.clear();
    this.turned.add(model.root);
    model.root.position.copy(this.centre).negate();
    this.aimCamera(height ?? FILLED * clientHeight, clientWidth, clientHeight);
    this.renderer.render(this.scene, this.camera);
  }

  /** A diagonal of `pixels` in the middle of the picture, from so far away that there is no perspective distortion. */
  private aimCamera(pixels: number, width: number, height: number): void {
    const { camera, radius } = this;
    // Zoom, not proximity, makes it large: a camera nearby would see one end from inside the body.
    const distance = 5 * radius;
    const seen = 2 * distance * Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2));
    camera.zoom = (pixels * seen) / (height * 2 * radius);
    camera.aspect = width / height;
    camera.near = radius;
    camera.far = 10 * radius;
    camera.position.set(0, 0.35 * distance, 0.937 * distance);
    camera.lookAt(0, 0, 0);
    camera.updateProjectionMatrix();
  }

  dispose(): void {
    for (const model of this.models) model.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
