/** Results of methods at an equal budget as a table. */

import type { Column, Table } from '../../report/tables/method_table';
import type { ComparedMethod, MethodResult } from './equal_budget';

/** The names of the methods in papers and release notes. */
export const METHOD_TITLES: Record<ComparedMethod, string> = {
  limber: 'Limber',
  paper: 'Paper',
  qem: 'QEM',
  'meshoptimizer simplify': 'meshoptimizer, simplify',
  'meshoptimizer update': 'meshoptimizer, update + Regularize',
};

const COLUMNS = [
  [{ title: 'Method', digits: null }, ({ name }) => METHOD_TITLES[name]],
  [{ title: 'Faces', digits: 0 }, ({ faces }) => faces],
  [{ title: 'Mean distance, %', digits: 3 }, ({ mean }) => mean],
  [{ title: 'Hausdorff distance, %', digits: 2 }, ({ hausdorff }) => hausdorff],
  [{ title: 'Mean frequency error, %', digits: 2 }, ({ frequencyErrorMean }) => frequencyErrorMean],
  [{ title: 'Lowest MAC', digits: 3 }, ({ macMin }) => macMin],
  [{ title: 'Smallest angle, °', digits: 1 }, ({ minAngle }) => minAngle],
  [{ title: 'Area, %', digits: 2 }, ({ areaChange }) => areaChange],
  [{ title: 'Volume, %', digits: 2 }, ({ volumeChange }) => volumeChange],
  [{ title: 'Topology', digits: null }, ({ isTopologyKept }) => (isTopologyKept ? 'kept' : 'changed')],
  [{ title: 'Time, s', digits: 2 }, ({ seconds }) => seconds],
] as const satisfies readonly [Column, (result: MethodResult) => string | number | null][];

/** `model`: the name of the file; `faces`: the budget, of so many in the original. */
export function budgetTable(
  results: readonly MethodResult[],
  { model, faces, originalFaces }: { model: string; faces: number; originalFaces: number },
): Table {
  return {
    caption: `${model}: methods at ${faces} of ${originalFaces} faces; distances in % of the diagonal, frequencies of modes 1 to 10 as shells`,
    columns: COLUMNS.map(([column]) => column),
    rows: results.map((result) => COLUMNS.map(([, read]) => read(result))),
  };
}
