/** The axes of the scene in a corner of the viewport: x to the right, y up, z towards the viewer, as in glTF. */

import * as THREE from 'three';

const SIZE = 64;
// Bright enough for a dark ground, dark enough for a light one.
const AXES = [
  { letter: 'X', colour: '#e05252', way: new THREE.Vector3(1, 0, 0) },
  { letter: 'Y', colour: '#35a352', way: new THREE.Vector3(0, 1, 0) },
  { letter: 'Z', colour: '#4c84e6', way: new THREE.Vector3(0, 0, 1) },
];

export class AxesMark {
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.OrthographicCamera(-1.5, 1.5, 1.5, -1.5, 0.1, 10);

  constructor() {
    for (const { letter, colour, way } of AXES) {
      const material = new THREE.LineBasicMaterial({ color: colour, toneMapped: false });
      const geometry = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), way]);
      const label = new THREE.Sprite(
        new THREE.SpriteMaterial({
          map: letterTexture(letter, colour),
          premultipliedAlpha: true,
          toneMapped: false,
        }),
      );
      label.position.copy(way).multiplyScalar(1.24);
      label.scale.setScalar(0.72);
      this.scene.add(new THREE.Line(geometry, material), label);
    }
  }

  /** Draws at the lower left of the canvas, as seen from the camera; `toMesh`: the rotation of the scene for the camera. */
  draw(renderer: THREE.WebGLRenderer, camera: THREE.Camera, toMesh: THREE.Quaternion): void {
    this.camera.quaternion.copy(toMesh.clone().invert().multiply(camera.quaternion));
    this.camera.position.set(0, 0, 5).applyQuaternion(this.camera.quaternion);
    renderer.setViewport(6, 4, SIZE, SIZE);
    renderer.setScissor(6, 4, SIZE, SIZE);
    renderer.clearDepth();
    renderer.render(this.scene, this.camera);
  }
}

function letterTexture(letter: string, colour: string): THREE.CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  if (context) {
    context.font = '600 44px sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillStyle = colour;
    context.fillText(letter, 32, 34);
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  // Otherwise the edges of letters blend with the black around them.
  texture.premultiplyAlpha = true;
  return texture;
}
