/** Draws the collision scene: a floor, balls and capsules. */

import * as THREE from 'three';
import type { Collider, CollisionScene } from '../../engine/core/core';

/** In units of the mesh. */
export interface ShownCollisionScene extends CollisionScene {
  /** the height down to which a body will hang; null: not below its rest position */
  lowest: number | null;
  /** of the bounding box of the body */
  centre: number[];
  diagonal: number;
}

export interface CollisionSceneLook {
  floor: string;
  line: string;
  body: string;
}

/** Squares of the floor per diagonal. */
const SQUARES = 8;

const floorVertex = /* glsl */ `
  varying vec2 floorPosition;
  void main() {
    floorPosition = position.xz;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

// The squares fade out, so that the floor has no edge.
const floorFragment = /* glsl */ `
  varying vec2 floorPosition;
  uniform vec3 floorColour;
  uniform vec3 lineColour;
  uniform float cell;
  uniform float radius;
  void main() {
    vec2 at = floorPosition / cell;
    vec2 away = abs(fract(at - 0.5) - 0.5) / fwidth(at);
    float line = 1.0 - min(min(away.x, away.y), 1.0);
    float fade = 1.0 - smoothstep(0.35, 1.0, length(floorPosition) / radius);
    gl_FragColor = vec4(mix(floorColour, lineColour, line), fade * mix(0.5, 0.8, line));
    #include <colorspace_fragment>
  }
`;

export class CollisionSceneView {
  readonly group = new THREE.Group();

  /** Replaces the shown scene; null shows nothing. */
  show(scene: ShownCollisionScene | null, look: CollisionSceneLook): void {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      if (child instanceof THREE.Mesh) child.geometry.dispose();
    }
    if (!scene) return;
    if (scene.ground !== null) this.addGround(scene, scene.ground, look);
    for (const collider of scene.colliders) this.addCollider(collider, look);
    this.addLights();
  }

  private addGround(
    { centre, diagonal }: ShownCollisionScene,
    height: number,
    look: CollisionSceneLook,
  ): void {
    const radius = 0.95 * diagonal;
    const material = new THREE.ShaderMaterial({
      vertexShader: floorVertex,
      fragmentShader: floorFragment,
      transparent: true,
      side: THREE.DoubleSide,
      uniforms: {
        floorColour: { value: new THREE.Color(look.floor) },
        lineColour: { value: new THREE.Color(look.line) },
        cell: { value: diagonal / SQUARES },
        radius: { value: radius },
      },
    });
    const floor = new THREE.Mesh(new THREE.CircleGeometry(radius, 64).rotateX(-Math.PI / 2), material);
    // The floor is drawn slightly too low, so that it does not intersect bodies that rest on it.
    floor.position.set(centre[0], height - 0.004 * diagonal, centre[2]);
    this.group.add(floor);
  }

  private addLights(): void {
    const sun = new THREE.DirectionalLight('#ffffff', 1.1);
    sun.position.set(0.35, 0.75, 0.55);
    this.group.add(sun, new THREE.HemisphereLight('#ffffff', '#9a9a9a', 2));
  }

  private addCollider({ from, to, radius }: Collider, look: CollisionSceneLook): void {
    const [a, b] = [new THREE.Vector3(...from), new THREE.Vector3(...to)];
    // A collider is drawn slightly too small: flat triangles that lie on it would cut through its round surface.
    const geometry = new THREE.CapsuleGeometry(0.97 * radius, a.distanceTo(b), 16, 48);
    const body = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: look.body }));
    body.position.copy(a).add(b).multiplyScalar(0.5);
    if (a.distanceTo(b) > 0)
      body.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), b.clone().sub(a).normalize());
    this.group.add(body);
  }
}

/** Points that the camera must include to show the whole scene. */
export function pointsToShow({ ground, lowest, colliders, centre }: ShownCollisionScene): THREE.Vector3[] {
  const ends = colliders.flatMap(({ from, to, radius }) =>
    [from, to].flatMap((end) =>
      [-radius, radius].map((by) =>
        new THREE.Vector3(...end).add(new THREE.Vector3(by, by, by).divideScalar(1.5)),
      ),
    ),
  );
  const floors = [ground, lowest].filter((height) => height !== null);
  return [...ends, ...floors.map((height) => new THREE.Vector3(centre[0], height, centre[2]))];
}
