/** Reads GIF files, so that tests see what a viewer of them would show (GIF89a, with the blocks that Limber writes). */

export interface ReadGif {
  width: number;
  height: number;
  /** whether it plays again and again */
  isEndless: boolean;
  frames: { milliseconds: number; /** four bytes a pixel, as it is seen */ rgba: Uint8ClampedArray }[];
}

export function readGif(bytes: Uint8Array): ReadGif {
  const reader = new Reader(bytes);
  if (reader.text(6) !== 'GIF89a') throw new Error('not a GIF89a');
  const [width, height] = [reader.short(), reader.short()];
  const globalColours = reader.skipTo(reader.colourCount(), 2);
  const shown = new Uint8ClampedArray(4 * width * height);
  const frames: ReadGif['frames'] = [];
  let isEndless = false;
  let control = { milliseconds: 0, clear: -1 };
  for (;;) {
    const block = reader.byte();
    if (block === 0x3b) return { width, height, isEndless, frames };
    if (block === 0x21) {
      const label = reader.byte();
      const data = reader.blocks();
      if (label === 0xff)
        isEndless =
          String.fromCharCode(...data.subarray(0, 11)) === 'NETSCAPE2.0' && data[12] + data[13] === 0;
      if (label === 0xf9)
        control = { milliseconds: 10 * (data[1] + 256 * data[2]), clear: data[0] & 1 ? data[3] : -1 };
    } else {
      const box = [reader.short(), reader.short(), reader.short(), reader.short()];
      if (block !== 0x2c || box.join() !== [0, 0, width, height].join()) throw new Error('not a whole frame');
      const own = reader.colourCount();
      const colours = own ? reader.skipTo(own) : globalColours;
      const leastBits = reader.byte();
      const indices = decompress(reader.blocks(), leastBits, width * height);
      indices.forEach((index, i) => {
        if (index !== control.clear) shown.set([...colours.subarray(3 * index, 3 * index + 3), 255], 4 * i);
      });
      frames.push({ milliseconds: control.milliseconds, rgba: shown.slice() });
    }
  }
}

class Reader {
  private at = 0;
  constructor(private readonly bytes: Uint8Array) {}

  byte = (): number => this.bytes[this.at++];
  short = (): number => this.byte() + 256 * this.byte();
  text = (length: number): string => String.fromCharCode(...Array.from({ length }, this.byte));

  /** Reads the flags that say how many colours follow; 0: none. */
  colourCount(): number {
    const flags = this.byte();
    return flags & 0x80 ? 2 << (flags & 7) : 0;
  }

  /** Passes over `bytes` and reads a table of colours. */
  skipTo(count: number, bytes = 0): Uint8Array {
    this.at += bytes;
    return this.bytes.subarray(this.at, (this.at += 3 * count));
  }

  blocks(): Uint8Array {
    const data: number[] = [];
    for (let length = this.byte(); length > 0; length = this.byte())
      for (let i = 0; i < length; i++) data.push(this.byte());
    return Uint8Array.from(data);
  }
}

/** LZW with codes of variable length, the lowest bits first. */
function decompress(data: Uint8Array, leastBits: number, length: number): Uint8Array {
  const clear = 1 << leastBits;
  const out: number[] = [];
  let [table, bits]: [number[][], number] = [[], 0];
  const restart = (): void => {
    table = Array.from({ length: clear + 2 }, (_, i) => [i]);
    bits = leastBits + 1;
  };
  restart();
  let last: number[] | null = null;
  for (let at = 0; ;) {
    let code = 0;
    for (let bit = 0; bit < bits; bit++, at++) code |= ((data[at >> 3] >> (at & 7)) & 1) << bit;
    if (code === clear + 1) break;
    if (code === clear) {
      restart();
      last = null;
      continue;
    }
    const entry: number[] = code < table.length ? table[code] : [...last!, last![0]];
    for (const index of entry) out.push(index);
    if (last && table.length < 4096) table.push([...last, entry[0]]);
    if (table.length === 1 << bits && bits < 12) bits += 1;
    last = entry;
  }
  if (out.length !== length) throw new Error(`${out.length} pixels instead of ${length}`);
  return Uint8Array.from(out);
}
