/** Reads words and numbers from the bytes of a text file in one pass, without decoding the whole into a string. */

import { checkEncoding } from './checks/text_encoding';

const TAB = 9;
const NEWLINE = 10;
const RETURN = 13;
const SPACE = 32;
const PLUS = 43;
const MINUS = 45;
const POINT = 46;
const ZERO = 48;
const BACKSLASH = 92;
const LOWER_E = 101;

/** Powers of ten that are exact in a double: 10^0 to 10^22. */
const EXACT_POWERS = Array.from({ length: 23 }, (_, exponent) => Number(`1e${exponent}`));
/** Integers of up to this many digits are exact in a double. */
const EXACT_DIGITS = 15;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

export class TextScanner {
  /** current line, from 1 */
  line = 1;
  /** current byte offset */
  at: number;

  /** Throws an Error with one sentence where the file starts as text in another encoding than UTF-8. */
  constructor(
    private readonly file: string,
    private readonly bytes: Uint8Array,
    start = 0,
  ) {
    if (start === 0) checkEncoding(file, bytes);
    const hasMark = start === 0 && bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
    this.at = hasMark ? 3 : start;
  }

  get atEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  /** Skips blanks on this line, which a final backslash continues on the next; returns whether a word follows. */
  seekWord(): boolean {
    for (; this.at < this.bytes.length; ++this.at) {
      const byte = this.bytes[this.at];
      if (byte === BACKSLASH && this.isNewline(this.at + 1)) {
        ++this.at;
        this.passNewline();
        --this.at;
      } else if (byte !== SPACE && byte !== TAB) return byte !== NEWLINE && byte !== RETURN;
    }
    return false;
  }

  /** Skips blanks and line ends; returns whether a word follows. */
  seekWordAnywhere(): boolean {
    while (!this.seekWord()) {
      if (this.atEnd) return false;
      this.passNewline();
    }
    return true;
  }

  /** Goes to the start of the next line. */
  nextLine(): void {
    while (this.at < this.bytes.length && !this.isNewline(this.at)) ++this.at;
    this.passNewline();
  }

  /** Reads the next word; '' at the end of the line. */
  word(): string {
    if (!this.seekWord()) return '';
    const start = this.at++; // a control character counts as a word, so that readers of words make progress
    while (this.at < this.bytes.length && this.bytes[this.at] > SPACE) ++this.at;
    return this.text(start, this.at);
  }

  /** Reads the rest of this line, without surrounding blanks. */
  rest(): string {
    this.seekWord();
    const start = this.at;
    while (this.at < this.bytes.length && !this.isNewline(this.at)) ++this.at;
    return this.text(start, this.at).trim();
  }

  /** The current byte; -1 at the end of the file. */
  peek(): number {
    return this.at < this.bytes.length ? this.bytes[this.at] : -1;
  }

  /** Reads a finite number, correctly rounded to a double. Throws an Error that calls it `what`. */
  number(what: string): number {
    if (!this.seekWord()) this.failMissing(what);
    const start = this.at;
    const value = this.shortDecimal();
    return Number.isNaN(value) ? this.slowNumber(start, what) : value;
  }

  /** Reads the next word as a number; NaN if it is not one or the line ends. */
  numberOrNaN(): number {
    if (!this.seekWord()) return NaN;
    const start = this.at;
    const value = this.shortDecimal();
    if (!Number.isNaN(value)) return value;
    this.at = start;
    const word = this.word();
    return NUMBER.test(word) ? Number(word) : NaN;
  }

  /** Reads an integer with an optional sign and stops at the first other byte; NaN if there are no digits. */
  integer(): number {
    const isNegative = this.passSign();
    let value = 0;
    const start = this.at;
    for (let digit; (digit = this.digit()) >= 0; ++this.at) value = 10 * value + digit;
    if (this.at === start) return NaN;
    return isNegative ? -value : value;
  }

  private failMissing(what: string): never {
    if (this.peek() >= 0) this.fail(`${what} is missing`);
    this.fail(`${what} is missing and the file seems cut off: export it again`);
  }

  fail(problem: string): never {
    throw new Error(`${this.file}, line ${this.line}: ${problem}.`);
  }

  /** Reads a decimal whose digits and power of ten are exact, so that one operation rounds correctly; otherwise NaN. */
  private shortDecimal(): number {
    const isNegative = this.passSign();
    const start = this.at;
    let mantissa = 0;
    let digits = 0;
    let decimals = 0;
    for (let digit; (digit = this.digit()) >= 0; ++this.at, ++digits) mantissa = 10 * mantissa + digit;
    if (this.peek() === POINT) {
      ++this.at;
      for (let digit; (digit = this.digit()) >= 0; ++this.at, ++digits, ++decimals)
        mantissa = 10 * mantissa + digit;
    }
    let exponent = -decimals;
    if ((this.peek() | SPACE) === LOWER_E && digits > 0) {
      ++this.at;
      exponent += this.integer();
    }
    const isExact = digits > 0 && this.at - start < 40 && Math.abs(exponent) < EXACT_POWERS.length;
    if (!isExact || this.peek() > SPACE || (digits > EXACT_DIGITS && mantissa >= 2 ** 53)) return NaN;
    const value = exponent < 0 ? mantissa / EXACT_POWERS[-exponent] : mantissa * EXACT_POWERS[exponent];
    return isNegative ? -value : value;
  }

  private slowNumber(start: number, what: string): number {
    this.at = start;
    const word = this.word();
    const value = NUMBER.test(word) ? Number(word) : NaN;
    if (Number.isNaN(value) && !/nan|inf|#/i.test(word))
      this.fail(`${what} is "${excerpt(word)}", not a number`);
    if (!Number.isFinite(value)) this.fail(`${what} is ${excerpt(word)}, not a finite number`);
    return value;
  }

  private passSign(): boolean {
    const byte = this.peek();
    if (byte === MINUS || byte === PLUS) ++this.at;
    return byte === MINUS;
  }

  /** The current decimal digit; negative if there is none. */
  private digit(): number {
    const digit = this.peek() - ZERO;
    return digit > 9 ? -1 : digit;
  }

  private isNewline(at: number): boolean {
    return this.bytes[at] === NEWLINE || this.bytes[at] === RETURN;
  }

  /** Skips the line end at the current byte: LF, CR LF or CR. */
  private passNewline(): void {
    if (this.at >= this.bytes.length) return;
    if (this.bytes[this.at] === RETURN && this.bytes[this.at + 1] === NEWLINE) ++this.at;
    ++this.at;
    ++this.line;
  }

  private text(start: number, end: number): string {
    if (end - start === 1) return String.fromCharCode(this.bytes[start]);
    return new TextDecoder().decode(this.bytes.subarray(start, end));
  }
}

/** At most 40 printable characters of untrusted text, to be quoted in a message. */
export function excerpt(text: string): string {
  const plain = text.replace(/[^\x20-\x7e\u00a0-\uffff]/g, '?');
  return plain.length > 40 ? `${plain.slice(0, 37)}...` : plain;
}
