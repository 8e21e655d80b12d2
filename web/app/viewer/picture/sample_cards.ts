/** Moving pictures of files: one shared renderer draws them in turn and copies each to its own small canvas. */

import * as THREE from 'three';
import { lightByRoom } from '../room_light';
import { SceneModel } from '../file/scene_model';

const FRAME_MILLISECONDS = 40;
const WIDTH = 440;
const HEIGHT = 300;
/** Seconds of a whole turn. */
const ROUND_SECONDS = 18;

interface Card {
  canvas: HTMLCanvasElement;
  model: SceneModel;
  box: THREE.Box3;
}

export class SampleCards {
  private readonly scene = new THREE.Scene();
  private readonly turned = new THREE.Group();
  private readonly camera = new THREE.PerspectiveCamera(30, WIDTH / HEIGHT, 0.01, 1000);
  private readonly cards: Card[] = [];
  private lastDrawn = -1e9;
  private isDisposed = false;

  /** Loads the files one after the other and shows each as soon as it is loaded; null without WebGL2. */
  static open(
    addresses: readonly string[],
    canvases: readonly HTMLCanvasElement[],
    isStill: boolean,
  ): SampleCards | null {
    try {
      const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
      const cards = new SampleCards(renderer, isStill);
      void cards.load(addresses, canvases);
      return cards;
    } catch {
      return null; // names and buttons are still useful
    }
  }

  private constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly isStill: boolean,
  ) {
    renderer.setSize(WIDTH, HEIGHT, false);
    renderer.toneMapping = THREE.NeutralToneMapping;
    const key = new THREE.DirectionalLight('#ffffff', 1.3);
    key.position.set(-1, 2, 1.5);
    this.scene.add(this.turned, key);
    if (!isStill) renderer.setAnimationLoop((time) => this.frame(time));
  }

  private async load(addresses: readonly string[], canvases: readonly HTMLCanvasElement[]): Promise<void> {
    await lightByRoom(this.scene);
    for (const [i, address] of addresses.entries()) {
      const response = await fetch(address);
      if (!response.ok) continue;
      const model = await SceneModel.load(new Uint8Array(await response.arrayBuffer()));
      if (this.isDisposed) return model.dispose();
      this.cards.push({ canvas: canvases[i], model, box: new THREE.Box3().setFromObject(model.root) });
      if (this.isStill) this.draw(0);
    }
  }

  dispose(): void {
    this.isDisposed = true;
    this.renderer.setAnimationLoop(null);
    for (const { model } of this.cards) model.dispose();
    // Forcing a context loss would wait for all pending drawing.
    this.renderer.dispose();
  }

  private frame(time: number): void {
    if (time - this.lastDrawn < FRAME_MILLISECONDS) return;
    this.lastDrawn = time;
    this.draw(time / 1000);
  }

  private draw(seconds: number): void {
    this.cards.forEach((card, i) => {
      const context = card.canvas.getContext('2d');
      if (!context) return;
      this.show(card, seconds, i);
      this.renderer.render(this.scene, this.camera);
      context.clearRect(0, 0, WIDTH, HEIGHT);
      context.drawImage(this.renderer.domElement, 0, 0, WIDTH, HEIGHT);
    });
  }

  /** Every file rotates slowly, and leans to and fro as if it were swaying. */
  private show({ model, box }: Card, seconds: number, i: number): void {
    this.turned.clear();
    this.turned.add(model.root);
    const centre = box.getCenter(new THREE.Vector3());
    const { radius } = box.getBoundingSphere(new THREE.Sphere());
    model.root.position.copy(centre).negate();
    const angle = (2 * Math.PI * seconds) / ROUND_SECONDS;
    this.turned.rotation.set(0, 0.6 + angle, 0.06 * Math.sin(1.7 * seconds + i));
    this.camera.position.set(0, 1.3 * radius, 4.2 * radius);
    this.camera.near = radius / 20;
    this.camera.far = radius * 20;
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(0, 0, 0);
  }
}
