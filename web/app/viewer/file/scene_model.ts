/** A whole file, drawn with its own materials: its nodes, skins, animations and colours. */

import * as THREE from 'three';
import type { GLTFReference } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { spreadPoints, spreadStep } from '../spread_points';
import { checkerTexture, matcapTexture } from '../look_textures';
import { isBlankMaterial } from './blank_material';
import { shadeFolds } from './fold_shading';

shadeFolds();

export type SceneLookName = 'textured' | 'matcap' | 'clay' | 'checker';

export interface SceneLook {
  name: SceneLookName;
  isFlat: boolean;
  clay: string;
  wire: string;
  /** 0: no edges are drawn */
  wireStrength: number;
  /** indices of the file's shown meshes; null: all */
  shown: ReadonlySet<number> | null;
}

/** The drawn object of one primitive. */
interface Drawn {
  object: THREE.Mesh;
  /** its index among the file's meshes */
  mesh: number;
  own: THREE.Material | THREE.Material[];
  /** whether the file does not define its look, for which glTF prescribes white */
  isPlain: boolean;
  /** draws its edges; null until requested */
  edges: THREE.Mesh | null;
}

export class SceneModel {
  readonly root: THREE.Object3D;
  private readonly drawn: Drawn[] = [];
  private readonly mixer: THREE.AnimationMixer;
  private readonly clip: THREE.AnimationClip | null;
  private readonly made = new Map<string, THREE.Material>();

  /** Reads a GLB. Throws an Error if the loader cannot read it. */
  static async load(bytes: Uint8Array): Promise<SceneModel> {
    // Loaded on demand: the page appears without it.
    const { GLTFLoader } = await import('three/examples/jsm/loaders/GLTFLoader.js');
    const buffer = bytes.slice().buffer;
    const { scene, animations, parser } = await new GLTFLoader().parseAsync(buffer, '');
    return new SceneModel(scene, animations, parser.associations);
  }

  private constructor(
    root: THREE.Object3D,
    clips: THREE.AnimationClip[],
    associations: Map<THREE.Object3D | THREE.Material | THREE.Texture, GLTFReference>,
  ) {
    this.root = root;
    root.traverse((object) => {
      if (!(object instanceof THREE.Mesh)) return;
      object.frustumCulled = false;
      const own = object.material as THREE.Material | THREE.Material[];
      const isPlain = [own].flat().every((one) => !associations.get(one) && !one.vertexColors);
      this.drawn.push({ object, mesh: associations.get(object)?.meshes ?? -1, own, isPlain, edges: null });
    });
    // Among other materials, white is a deliberate colour; if all materials are blank, the file has no look of its own.
    if (this.drawn.every(({ own }) => [own].flat().every(isBlankMaterial)))
      for (const drawn of this.drawn) drawn.isPlain = true;
    this.mixer = new THREE.AnimationMixer(root);
    this.clip = clips[0] ?? null;
  }

  get isAnimated(): boolean {
    return this.clip !== null;
  }

  /** Puts its first animation at a time, in seconds; null: the rest pose. */
  pose(seconds: number | null): void {
    if (!this.clip) return;
    const action = this.mixer.clipAction(this.clip);
    if (seconds === null) action.stop();
    else {
      action.play();
      this.mixer.setTime(seconds);
    }
  }

  look(look: SceneLook): void {
    for (const drawn of this.drawn) {
      const { object, mesh, own } = drawn;
      object.visible = look.shown === null || look.shown.has(mesh);
      object.material = Array.isArray(own)
        ? own.map((one) => this.material(look, one, drawn))
        : this.material(look, own, drawn);
      this.showEdges(drawn, look);
    }
  }

  private material(look: SceneLook, own: THREE.Material, { object, isPlain }: Drawn): THREE.Material {
    const hasUv = object.geometry.hasAttribute('uv');
    const lacks = (look.name === 'textured' && isPlain) || (look.name === 'checker' && !hasUv);
    const name = lacks ? 'clay' : look.name;
    const isTextured = name === 'textured';
    if (isTextured && !look.isFlat) return own;
    const key = [name, look.isFlat, look.clay, isTextured ? own.uuid : ''].join(' ');
    const known = this.made.get(key);
    if (known) return known;
    const made = isTextured ? own.clone() : plainMaterial(name, look.clay);
    (made as THREE.MeshStandardMaterial).flatShading = look.isFlat || !object.geometry.hasAttribute('normal');
    this.made.set(key, made);
    return made;
  }

  private showEdges(drawn: Drawn, { wire, wireStrength }: SceneLook): void {
    if (wireStrength > 0) drawn.edges ??= addEdges(drawn.object);
    if (!drawn.edges) return;
    drawn.edges.visible = wireStrength > 0;
    const material = drawn.edges.material as THREE.MeshBasicMaterial;
    material.color.set(wire);
    material.opacity = wireStrength;
  }

  /** Points on the shown surfaces, in the space of the scene, `points[3 i + c]`. */
  points(): Float32Array {
    this.root.updateMatrixWorld(true);
    const toScene = (this.root.parent?.matrixWorld ?? new THREE.Matrix4()).clone().invert();
    const shown = this.drawn.filter(({ object }) => object.visible);
    const parts = shown.map(({ object }) => pointsOn(object, toScene.clone().multiply(object.matrixWorld)));
    const all = new Float32Array(parts.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const part of parts) {
      all.set(part, at);
      at += part.length;
    }
    return all;
  }

  dispose(): void {
    for (const { object, own } of this.drawn) {
      object.geometry.dispose();
      for (const material of [own].flat()) disposeMaterial(material);
    }
    for (const material of this.made.values()) material.dispose();
  }
}

/** Points on a primitive in its pose, after a transformation; vertices that no point needs are skipped. */
function pointsOn(object: THREE.Mesh, matrix: THREE.Matrix4): Float32Array {
  const index = object.geometry.index?.array ?? null;
  const { count } = object.geometry.getAttribute('position');
  const positions = new Float32Array(3 * count);
  const isKnown = new Uint8Array(count);
  const point = new THREE.Vector3();
  const corners = index?.length ?? count;
  const step = 3 * spreadStep(Math.floor(corners / 3));
  for (let first = 0; first + 2 < corners; first += step)
    for (let corner = first; corner < first + 3; corner++) {
      const v = index ? index[corner] : corner;
      if (isKnown[v] === 1) continue;
      isKnown[v] = 1;
      object
        .getVertexPosition(v, point)
        .applyMatrix4(matrix)
        .toArray(positions, 3 * v);
    }
  return spreadPoints(positions, index);
}

function plainMaterial(name: SceneLookName, clay: string): THREE.Material {
  const side = THREE.DoubleSide;
  if (name === 'matcap') return new THREE.MeshMatcapMaterial({ matcap: matcapTexture(), side });
  if (name === 'checker')
    return new THREE.MeshStandardMaterial({ map: checkerTexture(), roughness: 0.8, side });
  return new THREE.MeshStandardMaterial({ color: clay, roughness: 0.75, side });
}

/** A child that draws the edges of a mesh, and moves with it. */
function addEdges(object: THREE.Mesh): THREE.Mesh {
  const material = new THREE.MeshBasicMaterial({
    wireframe: true,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
    toneMapped: false,
  });
  const edges =
    object instanceof THREE.SkinnedMesh
      ? new THREE.SkinnedMesh(object.geometry, material)
      : new THREE.Mesh(object.geometry, material);
  if (object instanceof THREE.SkinnedMesh && edges instanceof THREE.SkinnedMesh)
    edges.bind(object.skeleton, object.bindMatrix);
  edges.morphTargetInfluences = object.morphTargetInfluences;
  edges.morphTargetDictionary = object.morphTargetDictionary;
  edges.frustumCulled = false;
  object.add(edges);
  return edges;
}

function disposeMaterial(material: THREE.Material): void {
  for (const value of Object.values(material)) if (value instanceof THREE.Texture) value.dispose();
  material.dispose();
}
