/** The summary as one HTML file without anything beside it: styles and pictures are inside, and there is no script. */

import { VERSION } from '../../engine/core/version';
import { counted, grouped } from '../../engine/core/words';
import { describeTotals, resultOf } from './summary';
import type { Summary, SummaryRow } from './summary';

const STYLES = `
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem; color: #1c2330; background: #fff; }
table { border-collapse: collapse; }
th, td { padding: .35rem .6rem; text-align: right; border-bottom: 1px solid #dde2ea; vertical-align: middle; }
th { position: sticky; top: 0; background: #fff; }
th:first-child, th:last-child, td:first-child, td.text { text-align: left; }
td:first-child { overflow-wrap: anywhere; min-width: 11rem; max-width: 26rem; }
td.text { min-width: 14rem; max-width: 30rem; overflow-wrap: anywhere; }
tr.failed td.text { color: #a3171b; }
tr.missed td.text { color: #7a4b00; }
td:first-child a { font-size: .85em; color: #1d5bb8; }
img { display: block; }
@media (prefers-color-scheme: dark) {
  body, th { color: #e5e9f0; background: #15181e; }
  th, td { border-color: #333a46; }
  td:first-child a { color: #8ab6ff; }
  tr.failed td.text { color: #ff8d8f; }
  tr.missed td.text { color: #e8b45c; }
}`;

/** Failures first, then what missed a target, then the largest deviations. `pictureOf`: a PNG of before beside after; null: none. */
export function summaryHtml(
  { totals, assets }: Summary,
  pictureOf: (asset: string) => Uint8Array | null,
): string {
  const rows = [...assets].sort((a, b) => rank(a) - rank(b) || (b.deviation ?? 0) - (a.deviation ?? 0));
  const body = rows.map((row, i) => htmlRow(row, i < MAX_PICTURES ? pictureOf(row.asset) : null));
  const less =
    rows.length > MAX_PICTURES
      ? `<p>Only the first ${grouped(MAX_PICTURES)} assets have pictures, to keep the file small.</p>`
      : '';
  return `<!doctype html>
<!-- Limber ${VERSION} -->
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>Batch of ${counted(totals.assets, 'asset')}</title>
<style>${STYLES}
</style>
</head>
<body>
<h1>Batch</h1>
<p>${escape(describeTotals(totals))}</p>
${less}
<table>
<thead><tr>${HEADS.map((head) => `<th scope="col">${head}</th>`).join('')}</tr></thead>
<tbody>
${body.join('\n')}
</tbody>
</table>
</body>
</html>
`;
}

const MAX_PICTURES = 1000;
const HEADS = [
  'Asset',
  'Before and after',
  'Faces before',
  'Faces after',
  'Deviation',
  'Frequency error',
  'Bytes before',
  'Bytes after',
  'Seconds',
  'State',
];
const rank = ({ state }: SummaryRow): number => ['failed', 'missed', 'done'].indexOf(state);

function htmlRow(row: SummaryRow, picture: Uint8Array | null): string {
  const number = (value: number | null) => (value === null ? '' : grouped(value));
  const share = (value: number | null) => (value === null ? '' : `${value.toFixed(2)} %`);
  const state = row.state === 'done' && row.isUnchanged ? 'up to date' : row.state;
  const data = picture && Buffer.from(picture).toString('base64');
  const image = data
    ? `<img src="data:image/png;base64,${data}" alt="${escape(row.asset)} before and after" loading="lazy">`
    : '';
  const cells = [
    `${escape(row.asset)}${linkTo(resultOf(row))}`,
    image,
    ...[number(row.facesBefore), number(row.facesAfter), share(row.deviation), share(row.frequencyError)],
    ...[number(row.bytesBefore), number(row.bytesAfter)],
    row.seconds.toFixed(2),
  ].map((html) => `<td>${html}</td>`);
  const words = [state, ...row.sentences].map(escape).join('<br>');
  return `<tr class="${row.state}">${cells.join('')}<td class="text">${words}</td></tr>`;
}

/** The page stands in OUT, below which results are. A letter that is half of one, as names on Windows can have, is in no address. */
function linkTo(result: string | null): string {
  if (result === null) return '';
  const parts = Buffer.from(result).toString().split('/');
  return `<br><a href="${escape(parts.map(encodeURIComponent).join('/'))}">${escape(result)}</a>`;
}

const ENTITIES: Record<string, string> = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
  "'": '&#39;',
};

export const escape = (text: string): string => text.replace(/[&<>"']/g, (letter) => ENTITIES[letter]);
