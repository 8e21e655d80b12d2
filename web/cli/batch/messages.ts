/** The messages between a batch and its worker processes. */

import type { Arguments } from '../arguments';
import type { AssetRequest } from './orders';
import type { AssetRecord, WrittenFile } from './record';

export interface WorkOrder extends Pick<AssetRequest, 'options' | 'fromPreset'> {
  asset: string;
  /** as for limber optimize; the paths are those where results are to be in the end */
  args: Arguments;
  /** the path of the result below OUT, parted by slashes */
  result: string;
  /** a folder of the worker's own, into which it writes */
  folder: string;
  /** the folder OUT */
  out: string;
}

/** A file in the worker's folder, and where it is to be. */
export interface StagedFile extends WrittenFile {
  staged: string;
  path: string;
}

export interface WorkDone {
  record: AssetRecord;
  files: StagedFile[];
  /** where the picture for the summary is; null: it could not be drawn */
  picture: string | null;
  /** bytes that the worker has in memory */
  memory: number;
}
