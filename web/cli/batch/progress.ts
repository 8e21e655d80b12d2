/** What a batch says on the way: a line for each asset, and on a terminal that can redraw one line that stays. */

import { canRedraw, redrawn } from '../terminal';
import { grouped } from '../../engine/core/words';
import { facesChange, inOneLine } from '../words';
import type { AssetRecord } from './record';

/** What progress is written to. */
type Stream = Pick<NodeJS.WriteStream, 'write'> & { isTTY?: boolean; columns?: number };

export class BatchProgress {
  private finished = 0;
  private failed = 0;
  private readonly working = new Set<string>();
  private shown = 0;
  private readonly isLive: boolean;

  constructor(
    private readonly total: number,
    private readonly options: { quiet: boolean; stream?: Stream },
  ) {
    this.isLive = !options.quiet && canRedraw(this.stream);
  }

  begin(asset: string): void {
    this.working.add(asset);
    this.redraw();
  }

  /** `isUnchanged`: it was up to date, of which plain terminals are told only in the end. */
  end(record: AssetRecord, isUnchanged: boolean): void {
    this.working.delete(record.asset);
    ++this.finished;
    if (record.state === 'failed') ++this.failed;
    if (!this.options.quiet && !isUnchanged && (!this.isLive || record.state !== 'done'))
      this.say(this.lineOf(record));
    this.redraw();
  }

  /** Empties the line that stays. */
  clear(): void {
    if (this.shown > 0) this.stream.write(`${redrawn('', this.shown)}\r`);
    this.shown = 0;
  }

  private get stream(): Stream {
    return this.options.stream ?? process.stderr;
  }

  private say(line: string): void {
    this.clear();
    this.stream.write(`${inOneLine(line)}\n`);
  }

  private lineOf(record: AssetRecord): string {
    const head = `[${grouped(this.finished)}/${grouped(this.total)}] ${record.asset}`;
    return `${head}: ${describeRecord(record)}`;
  }

  private redraw(): void {
    if (!this.isLive) return;
    const failed = this.failed > 0 ? `, ${grouped(this.failed)} failed` : '';
    const names = [...this.working].join(', ');
    const whole = inOneLine(`${grouped(this.finished)} of ${grouped(this.total)} assets${failed}: ${names}`);
    const text = whole.slice(0, Math.max(20, (this.stream.columns ?? 80) - 1));
    this.stream.write(redrawn(text, this.shown));
    this.shown = text.length;
  }
}

/** What is said of an asset as a whole sentence in one line: after its path, which stands in place of its file's name. */
export function sentenceOn(path: string, words: string): string {
  const [asset, sentence] = [path, words].map(inOneLine);
  const name = asset.slice(asset.lastIndexOf('/') + 1);
  const isNamed = sentence.startsWith(name) && /^[ ,:]/.test(sentence.slice(name.length));
  const said = isNamed ? `${asset}${sentence.slice(name.length)}` : `${asset}: ${sentence}`;
  return /[.?!]$/.test(said) ? said : `${said}.`;
}

/** What became of an asset, after its name. */
export function describeRecord({ state, sentences, ...numbers }: AssetRecord): string {
  if (state === 'failed') return `failed: ${sentences[0]}`;
  const { facesBefore, facesAfter, deviation, seconds } = numbers;
  if (facesBefore === null || facesAfter === null) return sentences.join('; ');
  return [
    facesChange(facesBefore, facesAfter),
    ...(deviation === null ? [] : [`deviation ${deviation.toFixed(2)} %`]),
    `${seconds.toFixed(1)} s`,
    ...(state === 'missed' ? [`missed a target: ${sentences[0]}`] : []),
  ].join(', ');
}
