/** The one renderer of a page of many pictures: each is drawn here and copied to its own canvas. */

import * as THREE from 'three';
import { lightByRoom } from '../app/viewer/room_light';

export class Stage {
  private readonly scene = new THREE.Scene();

  private constructor(private readonly renderer: THREE.WebGLRenderer) {
    renderer.toneMapping = THREE.NeutralToneMapping;
    const key = new THREE.DirectionalLight('#ffffff', 1.2);
    key.position.set(-1, 2, 1.5);
    this.scene.add(key);
  }

  /** Throws without WebGL2. */
  static async open(): Promise<Stage> {
    const stage = new Stage(new THREE.WebGLRenderer({ antialias: true, alpha: true }));
    await lightByRoom(stage.scene);
    return stage;
  }

  draw(canvas: HTMLCanvasElement, model: THREE.Object3D, camera: THREE.PerspectiveCamera): void {
    const ratio = Math.min(devicePixelRatio, 2);
    const width = Math.round(ratio * canvas.clientWidth);
    const height = Math.round(ratio * canvas.clientHeight);
    if (width === 0 || height === 0) return;
    Object.assign(canvas, { width, height });
    this.renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    this.scene.add(model);
    this.renderer.render(this.scene, camera);
    this.scene.remove(model);
    canvas.getContext('2d')?.drawImage(this.renderer.domElement, 0, 0);
  }
}
