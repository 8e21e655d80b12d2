/** Off-screen pictures of meshes from one viewpoint, each in its own shape and colours. */

import * as THREE from 'three';
import type { TriangleMesh } from '../../../engine/core/core';
import { geometryFrom, setField } from '../body_geometry';
import type { Field } from '../body_geometry';
import { mapTexture } from '../colours';
import { drawnArrays } from '../drawn_arrays';
import { surfaceMaterial } from '../surface_material';
import { isLarge } from '../twin_surface';

export interface FigureBody {
  /** as drawn: at rest, in a mode or in motion */
  mesh: TriangleMesh;
  field: Field | null;
  hasWires: boolean;
}

export interface FigureEye {
  /** from the space of the camera, which looks along -z, to that of the meshes */
  orientation: THREE.Quaternion;
  /** height of each picture in pixels; its width follows from the meshes */
  height: number;
  clay: string;
  wire: string;
}

const FIELD_OF_VIEW = 24;
/** The margin around the meshes, as a fraction of the picture. */
const MARGIN = 1.06;
const WIRE_STRENGTH = 0.6;
/** Width over height of a picture. */
const SHAPES = { least: 0.55, most: 1.7 };
/** Vertices that are looked at to find out how large a mesh appears. */
const MAX_POINTS = 20_000;

/** Draws all bodies at one scale and yields each picture before the next one is drawn. Throws if WebGL2 is missing. */
export function drawFigure(
  bodies: readonly FigureBody[],
  eye: FigureEye,
  use: (canvas: HTMLCanvasElement, index: number) => void,
): void {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  const look = {
    clay: new THREE.Color(eye.clay),
    wire: new THREE.Color(eye.wire),
    wireStrength: WIRE_STRENGTH,
  };
  const material = surfaceMaterial(mapTexture('viridis'), look);
  try {
    const camera = cameraFor(bodies, eye);
    renderer.setSize(Math.round(camera.aspect * eye.height), eye.height, false);
    const scene = new THREE.Scene();
    bodies.forEach(({ mesh, field, hasWires }, index) => {
      const geometry = geometryFrom(drawnArrays(mesh), mesh);
      setField(geometry, mesh, field);
      material.uniforms.hasField.value = field !== null;
      material.uniforms.isFlat.value = isLarge(mesh);
      material.uniforms.wireStrength.value = hasWires ? WIRE_STRENGTH : 0;
      const body = new THREE.Mesh(geometry, material);
      scene.add(body);
      renderer.render(scene, camera);
      use(renderer.domElement, index);
      scene.remove(body);
      geometry.dispose();
    });
  } finally {
    material.dispose();
    renderer.dispose();
    renderer.forceContextLoss();
  }
}

/** The camera looks at the centre of all bodies, so close that they fill their pictures. */
function cameraFor(bodies: readonly FigureBody[], { orientation }: FigureEye): THREE.PerspectiveCamera {
  const back = orientation.clone().invert();
  const points = bodies.flatMap(({ mesh }) => somePoints(mesh)).map((point) => point.applyQuaternion(back));
  const box = new THREE.Box3().setFromPoints(points);
  const centre = box.getCenter(new THREE.Vector3());
  const size = box.getSize(new THREE.Vector3());
  const aspect = Math.min(SHAPES.most, Math.max(SHAPES.least, size.x / size.y || 1));
  const tangent = Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2)) / MARGIN;
  const distance = points.reduce((most, point) => {
    const { x, y, z } = point.clone().sub(centre);
    return Math.max(most, z + Math.max(Math.abs(x) / (tangent * aspect), Math.abs(y) / tangent));
  }, 0);
  const depth = size.length();
  const near = Math.max(distance - depth, distance / 100);
  const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, aspect, near, distance + depth);
  camera.position.copy(centre.setZ(centre.z + distance)).applyQuaternion(orientation);
  camera.quaternion.copy(orientation);
  camera.updateMatrixWorld();
  return camera;
}

function somePoints({ positions, triangles }: TriangleMesh): THREE.Vector3[] {
  const step = Math.max(1, Math.ceil(triangles.length / MAX_POINTS));
  const points: THREE.Vector3[] = [];
  for (let i = 0; i < triangles.length; i += step)
    points.push(new THREE.Vector3().fromArray(positions, 3 * triangles[i]));
  return points;
}
