// Runs in the browser: draws meshes side by side with flat shading and their edges on top. Bundled by pictures.mjs.

import {
  AmbientLight,
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderer,
  WireframeGeometry,
} from 'three';

/** The ratio of the visible size to the size of the body. */
const MARGIN = 1.08;

interface Panel {
  title: string;
  note: string;
  positions: number[];
  triangles: number[];
}

interface Picture {
  panels: Panel[];
  /** from the body towards the eye; +Y is up */
  view: [number, number, number];
  columns: number;
  /** height of a panel, pixels */
  width: number;
  height: number;
  /** whether the camera fits the bodies of all panels, not only that of the first */
  all?: boolean;
}

function sceneOf({ positions, triangles }: Panel): Scene {
  const indexed = new BufferGeometry();
  indexed.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  indexed.setIndex(triangles);
  const faces = indexed.toNonIndexed();
  faces.computeVertexNormals();
  const material = new MeshLambertMaterial({
    color: 0xb9cbd9,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  const edges = new LineBasicMaterial({ color: 0x1c2a36, transparent: true, opacity: 0.75 });
  const scene = new Scene();
  scene.background = new Color(0xffffff);
  scene.add(new Mesh(faces, material), new LineSegments(new WireframeGeometry(indexed), edges));
  return scene;
}

/** A camera that sees all of `positions` from the direction `view`, as large as `aspect` (width over height) allows. */
function cameraFor(positions: number[], view: Vector3, aspect: number): OrthographicCamera {
  const box = new Box3().setFromArray(positions);
  const distance = 2 * box.getSize(new Vector3()).length();
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1 * distance, 2 * distance);
  const centre = box.getCenter(new Vector3());
  camera.position.copy(centre).addScaledVector(view, distance);
  camera.lookAt(centre);
  camera.updateMatrixWorld();
  const points = new BufferAttribute(Float32Array.from(positions), 3);
  const seen = new Box3().setFromBufferAttribute(points.applyMatrix4(camera.matrixWorldInverse));
  const [size, middle] = [seen.getSize(new Vector3()), seen.getCenter(new Vector3())];
  const halfHeight = (MARGIN * Math.max(size.y, size.x / aspect)) / 2;
  camera.top = middle.y + halfHeight;
  camera.bottom = middle.y - halfHeight;
  camera.right = middle.x + halfHeight * aspect;
  camera.left = middle.x - halfHeight * aspect;
  camera.updateProjectionMatrix();
  return camera;
}

function addLights(scene: Scene, camera: OrthographicCamera): void {
  const light = new DirectionalLight(0xffffff, 2.2);
  light.position.copy(new Vector3(-0.5, 0.8, 1).transformDirection(camera.matrixWorld));
  scene.add(new AmbientLight(0xffffff, 1.1), light);
}

/** Adds a figure with a caption for every panel. */
function draw({ panels, view, columns, width, height, all }: Picture): void {
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(width, height);
  const positions = all ? panels.flatMap((panel) => panel.positions) : panels[0].positions;
  const camera = cameraFor(positions, new Vector3(...view).normalize(), width / height);
  document.body.style.cssText = `margin:0;background:#fff;font:14px sans-serif;color:#222;display:grid;grid-template-columns:repeat(${columns},${width}px);width:${columns * width}px`;
  for (const panel of panels) {
    const scene = sceneOf(panel);
    addLights(scene, camera);
    renderer.render(scene, camera);
    const figure = document.createElement('figure');
    figure.style.cssText = 'margin:0;text-align:center;padding-bottom:8px';
    const image = document.createElement('img');
    image.src = renderer.domElement.toDataURL();
    const [title, note] = ['b', 'div'].map((tag) => document.createElement(tag));
    title.textContent = panel.title;
    note.textContent = panel.note;
    figure.append(image, title, note);
    document.body.append(figure);
  }
}

Object.assign(globalThis, { draw });
