/** What a batch remembers of an asset: what it was made from, what was written, and the row of the summary. */

/** done: all as asked; missed: written, but short of a target; failed: not written. */
export type AssetState = 'done' | 'missed' | 'failed';

export interface WrittenFile {
  /** its path below OUT, parted by slashes */
  name: string;
  bytes: number;
  /** hexadecimal */
  sha256: string;
}

/** Numbers of an asset; null: not known, or it has none. */
export interface AssetNumbers {
  facesBefore: number | null;
  facesAfter: number | null;
  /** largest distance of the surfaces, in % of the diagonal */
  deviation: number | null;
  /** mean error of the first ten frequencies, in %; of the part where it is largest */
  frequencyError: number | null;
  seconds: number;
  /** of the model with what it names, before and after; levels and reports do not count */
  bytesBefore: number;
  bytesAfter: number | null;
}

export interface AssetRecord extends AssetNumbers {
  /** path below SRC */
  asset: string;
  state: AssetState;
  /** hash of all that the result follows from; '' where the input could not be read */
  key: string;
  /** of one that failed: in the journal what an earlier run has written, elsewhere nothing */
  written: WrittenFile[];
  /** why it failed or missed its target, and warnings: whole clauses */
  sentences: string[];
}

export const NO_NUMBERS: AssetNumbers = {
  facesBefore: null,
  facesAfter: null,
  deviation: null,
  frequencyError: null,
  seconds: 0,
  bytesBefore: 0,
  bytesAfter: null,
};

export const failedRecord = (asset: string, sentence: string, seconds = 0): AssetRecord => ({
  ...{ asset, state: 'failed', key: '', written: [], sentences: [sentence] },
  ...NO_NUMBERS,
  seconds,
});
