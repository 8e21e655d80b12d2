// Prints a table for tuning: one line per mesh at one ratio, and the means.

import { measure } from './measure.mjs';

const COLUMNS = [
  ['f 1-10', 'frequencyErrorMean', 2],
  ['max', 'frequencyErrorMax', 1],
  ['calib.', 'frequencyErrorCalibrated', 2],
  ['thin', 'frequencyErrorThin', 2],
  ['thick', 'frequencyErrorThick', 2],
  ['f 11-20', 'frequencyErrorHigh', 2],
  ['MAC min', 'macMin', 3],
  ['mean d', 'meanDistance', 4],
  ['Hausd.', 'hausdorff', 2],
  ['min a', 'minAngle', 1],
  ['mean a', 'meanMinAngle', 1],
  ['s', 'seconds', 1],
];
const NAME_WIDTH = 16;
const WIDTH = 9;

const line = (name, cells) => name.padEnd(NAME_WIDTH) + cells.map((cell) => cell.padStart(WIDTH)).join('');
const mean = (records, key) => records.reduce((sum, record) => sum + record[key], 0) / records.length;
const cellsOf = (valueOf) => COLUMNS.map(([, key, digits]) => valueOf(key)?.toFixed(digits) ?? '-');

/**
 * Prints lines as they are computed: errors in %, lengths in % of the diagonal, angles in degrees, seconds without the
 * measurement. The last line of a method has its means divided by those of `peer`, a list of cases on the same meshes.
 */
export function printQuickTable(loaded, { meshes, methods, ratio, peer }) {
  for (const method of methods) {
    console.log(`\n${method.name}, ${100 * ratio} % of the faces`);
    console.log(
      line(
        '',
        COLUMNS.map(([title]) => title),
      ),
    );
    const records = meshes.map((mesh) => {
      const { mesh: result, seconds } = method.run(mesh, ratio * mesh.faces);
      const record = { mesh: mesh.name, ...measure(loaded, mesh.prepared, result), seconds };
      console.log(
        line(
          mesh.name,
          cellsOf((key) => record[key]),
        ) + remarkOn(record),
      );
      return record;
    });
    printMeans(records, peer);
  }
}

const remarkOn = ({ topologyKept, failure }) =>
  [topologyKept ? '' : '  TOPOLOGY CHANGED', failure ? `  ${failure}` : ''].join('');

function printMeans(records, peer) {
  const isSolved = ({ mesh }) => [...records, ...peer].every((one) => one.mesh !== mesh || !one.failure);
  const [own, theirs] = [records, peer].map((list) => list.filter(isSolved));
  if (own.length === 0) return;
  console.log(
    line(
      'mean',
      cellsOf((key) => mean(own, key)),
    ),
  );
  console.log(
    line(
      'over peer',
      cellsOf((key) => mean(own, key) / mean(theirs, key)),
    ),
  );
}
