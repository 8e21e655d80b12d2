// Writes every sample as GLB, and index.json with the data of their cards. Usage: node make-samples.mjs FOLDER

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { sampleGlb } from './glb';
import { samples } from './samples';

const folder = process.argv[2];
if (!folder) throw new Error('make-samples needs the folder to write to as its argument.');
mkdirSync(folder, { recursive: true });
const index = [];
for (const sample of samples) {
  const { id, name, about } = sample;
  const shape = sample.make();
  const file = `${id}.glb`;
  writeFileSync(join(folder, file), await sampleGlb(sample, shape));
  index.push({
    id,
    name,
    file,
    faces: shape.triangles.length / 3,
    vertices: shape.positions.length / 3,
    about,
  });
}
writeFileSync(join(folder, 'index.json'), `${JSON.stringify(index, null, 2)}\n`);
