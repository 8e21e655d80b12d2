/** The flags of limber batch that no other command has. */

import { readMegabytes } from '../../engine/core/memory_size';
import { UsageError } from '../failure';
import type { Flag } from '../flag';

export interface BatchFlags {
  /** processes that work at a time; 0: as many as there are cores */
  jobs: number;
  /** megabytes that each of them may take; 0: its share of the memory */
  memory: number;
  /** null: there is none */
  config: string | null;
  /** whether assets are done that are up to date, too */
  again: boolean;
  reports: boolean;
  bindings: boolean;
  settingsFiles: boolean;
  frequencies: boolean;
}

export const BATCH_FLAGS: Flag[] = [
  {
    name: 'jobs',
    value: 'N',
    help: 'Number of assets processed at a time, each in its own process; 0 means one per core. Default: 0.',
    group: 'batch',
  },
  {
    name: 'config',
    value: 'FILE',
    help: 'JSON file with options for all assets and for some of them (docs/batch.md); flags take precedence over its options, and its overrides over flags.',
    group: 'batch',
  },
  {
    name: 'memory',
    value: 'SIZE',
    help: 'Memory limit of each job, such as 512M or 2G, or a number of megabytes: an asset that needs more fails without stopping the others. 0 divides four fifths of the memory among the jobs. Default: 0.',
    group: 'batch',
  },
  { name: 'again', help: 'Process assets again even if they are up to date.', group: 'batch' },
  { name: 'frequencies', help: 'Measure the frequency error of each asset.', group: 'batch' },
  { name: 'reports', help: 'Write a report beside each result (NAME.report.json).', group: 'output' },
  {
    name: 'bindings',
    help: 'Write the binding of the original vertices beside each result (NAME.bind.json).',
    group: 'output',
  },
  {
    name: 'settings-files',
    help: 'Write the settings file for the solver beside each result (NAME.settings.json).',
    group: 'output',
  },
];

/** More processes than this have no cores to run on. */
const MAX_JOBS = 256;

/** Throws UsageError. */
export function readBatchFlags(values: Map<string, string>): BatchFlags {
  return {
    jobs: readWhole(values, 'jobs', MAX_JOBS),
    memory: readMegabytes(values.get('memory') ?? '0', '--memory'),
    config: values.get('config') ?? null,
    again: values.has('again'),
    reports: values.has('reports'),
    bindings: values.has('bindings'),
    settingsFiles: values.has('settings-files'),
    frequencies: values.has('frequencies'),
  };
}

function readWhole(values: Map<string, string>, name: string, most: number): number {
  const text = values.get(name) ?? '0';
  const value = /^\d+$/.test(text) ? Number(text) : NaN;
  if (value <= most) return value;
  throw new UsageError(`--${name} is ${text}: give a whole number from 0 to ${most}.`);
}
