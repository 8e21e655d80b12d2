// Assets for batches: sheets, rings and bars in many sizes and bends, with a seed, as OBJ files in folders.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** Numbers in [0, 1), the same for a seed everywhere (mulberry32). */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const KINDS = {
  /** a bent sheet */
  sheet: (u, v, { bend }) => [u, bend * Math.sin(3 * u) * Math.cos(2 * v), v],
  /** a tube with a waist */
  tube: (u, v, { bend }) => {
    const radius = 0.3 + 0.1 * bend * Math.cos(6 * v);
    return [radius * Math.cos(2 * Math.PI * u), v, radius * Math.sin(2 * Math.PI * u)];
  },
  /** a ring */
  ring: (u, v, { bend }) => {
    const [a, b] = [2 * Math.PI * u, 2 * Math.PI * v];
    const radius = 1 + (0.25 + 0.1 * bend) * Math.cos(b);
    return [radius * Math.cos(a), 0.3 * Math.sin(b), radius * Math.sin(a)];
  },
};
const CLOSED = { sheet: [false, false], tube: [true, false], ring: [true, true] };

function objOf(kind, cells, bend) {
  const [closedU, closedV] = CLOSED[kind];
  const [nu, nv] = [cells, Math.max(4, Math.round(cells / 2))];
  const [pu, pv] = [closedU ? nu : nu + 1, closedV ? nv : nv + 1];
  const lines = [];
  for (let j = 0; j < pv; ++j)
    for (let i = 0; i < pu; ++i)
      lines.push(
        `v ${KINDS[kind](i / nu, j / nv, { bend })
          .map((x) => x.toFixed(7))
          .join(' ')}`,
      );
  const at = (i, j) => (j % pv) * pu + (i % pu) + 1;
  for (let j = 0; j < nv; ++j)
    for (let i = 0; i < nu; ++i) {
      lines.push(`f ${at(i, j)} ${at(i, j + 1)} ${at(i + 1, j)}`);
      lines.push(`f ${at(i + 1, j)} ${at(i, j + 1)} ${at(i + 1, j + 1)}`);
    }
  return `${lines.join('\n')}\n`;
}

/** Writes `count` assets of about `faces` faces and their double into `folder`, in a folder for each kind. */
export function writeAssets(folder, { count, faces, seed }) {
  const random = randomNumbers(seed);
  for (let i = 0; i < count; ++i) {
    const kind = Object.keys(KINDS)[i % 3];
    const cells = Math.max(8, Math.round(Math.sqrt(faces * (1 + random()))));
    mkdirSync(join(folder, kind), { recursive: true });
    writeFileSync(join(folder, kind, `${kind}_${i}.obj`), objOf(kind, cells, 0.2 + 0.6 * random()));
  }
}
