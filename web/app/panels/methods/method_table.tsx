/** The numbers of the methods, and buttons that copy them. */

import {
  shownValue,
  tableAsCsv,
  tableAsLatex,
  tableAsMarkdown,
} from '../../../engine/report/tables/method_table';
import type { Table } from '../../../engine/report/tables/method_table';
import { METHOD_TITLES } from '../../../engine/stages/equal_budget/budget_table';
import type { MethodResult } from '../../../engine/stages/equal_budget/equal_budget';
import { CopyButton } from '../../controls/copy_button';
import { say, sentence } from '../../language/say';

const FORMS = [
  { text: 'CSV', write: tableAsCsv },
  { text: 'Markdown', write: tableAsMarkdown },
  { text: 'LaTeX', write: tableAsLatex },
] as const;

export function MethodTable({ table, failures }: { table: Table; failures: readonly MethodResult[] }) {
  return (
    <>
      <div class="method-table" role="region" aria-label={say('Numbers of the methods')} tabIndex={0}>
        <table>
          <thead>
            <tr>
              {table.columns.map(({ title }) => (
                <th key={title} scope="col">
                  {say(title)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {table.rows.map((row) => (
              <tr key={row[0]}>
                {row.map((value, c) => {
                  const text = say(shownValue(value, table.columns[c]));
                  return c === 0 ? (
                    <th key={c} scope="row">
                      {text}
                    </th>
                  ) : (
                    <td key={c}>{text}</td>
                  );
                })}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <CopyButtons table={table} />
      {failures.map(({ name, failure }) => (
        <p key={name} class="hint">
          {say(METHOD_TITLES[name])}: {sentence(failure)}
        </p>
      ))}
      <p class="hint">
        {say(
          "Distances in % of the diagonal; frequencies of modes 1 to 10 as shells, as in the report; area and volume against the original. Time runs from the welded mesh to the result, modes and fit included. A limit that stops one of Limber's methods above this number of faces is lifted here. Your weights apply to the chosen method, and only Limber's methods respect pins, locks and paint.",
        )}
      </p>
    </>
  );
}

function CopyButtons({ table }: { table: Table }) {
  return (
    <div class="reports" role="group" aria-label={say('Copy the table')}>
      <span>{say('Copy as')}</span>
      {FORMS.map(({ text, write }) => (
        <CopyButton
          key={text}
          text={text}
          name={say('Copy as {format}', { format: text })}
          write={() => write(table)}
        />
      ))}
    </div>
  );
}
