/** What bodies fall on: a floor and balls or capsules, drawn in a scene beside a body. */

import * as THREE from 'three';

export interface Props {
  /** height of the floor along y; null: none */
  ground: number | null;
  capsules: { from: number[]; to: number[]; radius: number }[];
  /** of what stands on the floor, in units of the mesh */
  centre: number[];
  diagonal: number;
}

export interface PropsLook {
  floor: string;
  line: string;
  body: string;
}

const LINES = 24;

export class PropsView {
  readonly group = new THREE.Group();

  show(props: Props | null, look: PropsLook): void {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      if (child instanceof THREE.Mesh || child instanceof THREE.LineSegments) child.geometry.dispose();
    }
    if (!props) return;
    if (props.ground !== null) this.addGround(props, props.ground, look);
    for (const capsule of props.capsules) this.addCapsule(capsule, look);
  }

  private addGround({ centre, diagonal }: Props, height: number, look: PropsLook): void {
    const size = 3 * diagonal;
    const disc = new THREE.Mesh(
      new THREE.CircleGeometry(size / 2, 64).rotateX(-Math.PI / 2),
      new THREE.MeshBasicMaterial({
        color: look.floor,
        transparent: true,
        opacity: 0.55,
        side: THREE.DoubleSide,
      }),
    );
    // A little lower than it is, so that what rests on it is not cut by it.
    disc.position.set(centre[0], height - 0.004 * diagonal, centre[2]);
    this.group.add(disc, gridOf(size, look.line, disc.position));
  }

  private addCapsule({ from, to, radius }: Props['capsules'][number], look: PropsLook): void {
    const [a, b] = [new THREE.Vector3(...from), new THREE.Vector3(...to)];
    const geometry = new THREE.CapsuleGeometry(radius, a.distanceTo(b), 16, 48);
    const body = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: look.body }));
    body.position.copy(a).add(b).multiplyScalar(0.5);
    if (a.distanceTo(b) > 0)
      body.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), b.clone().sub(a).normalize());
    const sun = new THREE.DirectionalLight('#ffffff', 2);
    sun.position.set(0.35, 0.75, 0.55);
    this.group.add(body, sun, new THREE.AmbientLight('#ffffff', 1.2));
  }
}

/** Lines across a disc. */
function gridOf(size: number, color: string, at: THREE.Vector3): THREE.LineSegments {
  const ends: number[] = [];
  for (let i = 1; i < LINES; i++) {
    const place = size * (i / LINES - 0.5);
    const half = Math.sqrt((size / 2) ** 2 - place ** 2);
    ends.push(place, 0, -half, place, 0, half, -half, 0, place, half, 0, place);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(ends, 3));
  const material = new THREE.LineBasicMaterial({ color, transparent: true, opacity: 0.5 });
  const lines = new THREE.LineSegments(geometry, material);
  lines.position.copy(at);
  return lines;
}
