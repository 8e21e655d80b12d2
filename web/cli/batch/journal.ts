/**
 * The memory of a batch in OUT/.limber-batch: a journal, to which a line is added for every asset that is finished, and a manifest, into
 * which a run gathers what earlier journals have. A kill at any moment leaves at most half a line at the end, which does not count.
 */

import { closeSync, existsSync, fsyncSync, openSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { writeWhole } from '../files';
import { LineFile } from './line_file';
import type { AssetRecord } from './record';

const MANIFEST_SCHEMA = 'limber-batchmanifest/1';

interface Manifest {
  schema: string;
  assets: AssetRecord[];
}

export class Journal {
  private readonly records: Map<string, AssetRecord>;
  private lines: LineFile | null = null;

  /** Reads what earlier runs have left in `folder`, which need not exist. `notes`: what of it could not be used. */
  constructor(
    private readonly folder: string,
    readonly notes: string[] = [],
  ) {
    const manifest = readManifest(join(folder, 'manifest.json'), notes);
    const lines = readLines(join(folder, 'journal.jsonl'));
    this.records = new Map([...manifest, ...lines].map((record) => [record.asset, record]));
  }

  get(asset: string): AssetRecord | undefined {
    return this.records.get(asset);
  }

  all(): AssetRecord[] {
    return [...this.records.values()];
  }

  /**
   * Remembers a finished asset; a kill after this returns does not undo it. The results of one that has failed are as they were, and so
   * is what is remembered of them.
   */
  add(finished: AssetRecord): void {
    const { written = [] } = this.records.get(finished.asset) ?? {};
    const record = finished.state === 'failed' ? { ...finished, written } : finished;
    this.records.set(record.asset, record);
    this.lines ??= new LineFile(join(this.folder, 'journal.jsonl'));
    this.lines.add(JSON.stringify(record));
  }

  /** Gathers everything in the manifest; the folder has to exist. A kill in between leaves lines twice, which does no harm. */
  gather(): void {
    this.lines?.close();
    this.lines = null;
    const assets = this.all().sort((a, b) => (a.asset < b.asset ? -1 : 1));
    const manifest: Manifest = { schema: MANIFEST_SCHEMA, assets };
    const path = join(this.folder, 'manifest.json');
    writeWhole(path, `${JSON.stringify(manifest)}\n`);
    flush(path);
    rmSync(join(this.folder, 'journal.jsonl'), { force: true });
  }
}

/** When this returns, the content of a file is on the disk. */
function flush(path: string): void {
  const file = openSync(path, 'r+');
  try {
    fsyncSync(file);
  } finally {
    closeSync(file);
  }
}

function readManifest(path: string, notes: string[]): AssetRecord[] {
  if (!existsSync(path)) return [];
  try {
    const { schema, assets } = JSON.parse(readFileSync(path, 'utf8')) as Manifest;
    if (schema === MANIFEST_SCHEMA && Array.isArray(assets) && assets.every(isRecord)) return assets;
  } catch {
    // What is no JSON is treated as what is no manifest.
  }
  notes.push(`${path} is damaged or of another version: all assets are processed again`);
  return [];
}

/** Half a line, as a kill leaves it, does not parse. */
function readLines(path: string): AssetRecord[] {
  if (!existsSync(path)) return [];
  return readFileSync(path, 'utf8')
    .split('\n')
    .flatMap((line) => {
      try {
        const record: unknown = JSON.parse(line);
        return isRecord(record) ? [record] : [];
      } catch {
        return [];
      }
    });
}

function isRecord(value: unknown): value is AssetRecord {
  if (typeof value !== 'object' || value === null) return false;
  const { asset, key, state, written, sentences } = value as Partial<AssetRecord>;
  return (
    [asset, key].every((text) => typeof text === 'string') &&
    ['done', 'missed', 'failed'].includes(String(state)) &&
    Array.isArray(sentences) &&
    Array.isArray(written) &&
    written.every((file) => typeof file?.name === 'string' && typeof file.sha256 === 'string')
  );
}
