/** The summary as CSV (RFC 4180) in UTF-8. */

import { cell } from '../../engine/report/tables/csv_cell';
import { resultOf } from './summary';
import type { Summary, SummaryRow } from './summary';

const COLUMNS = [
  ['asset', (row) => row.asset],
  ['state', (row) => row.state],
  ['up to date', (row) => (row.isUnchanged ? 'yes' : 'no')],
  ['result', resultOf],
  ['faces before', (row) => row.facesBefore],
  ['faces after', (row) => row.facesAfter],
  ['deviation in %', (row) => row.deviation],
  ['frequency error in %', (row) => row.frequencyError],
  ['bytes before', (row) => row.bytesBefore],
  ['bytes after', (row) => row.bytesAfter],
  ['seconds', (row) => row.seconds],
  ['sentences', (row) => row.sentences.join('; ')],
] as const satisfies [string, (row: SummaryRow) => string | number | null][];

/** Without this mark Excel reads UTF-8 as the code page of the system. */
const BYTE_ORDER_MARK = '\ufeff';

export function summaryCsv({ assets }: Summary): string {
  const rows = [
    COLUMNS.map(([title]) => title),
    ...assets.map((row) => COLUMNS.map(([, read]) => read(row))),
  ];
  return BYTE_ORDER_MARK + rows.map((row) => `${row.map(cell).join(',')}\r\n`).join('');
}
