/** The structure of a PNG (ISO/IEC 15948): a signature, then chunks. */

/** The first bytes of every PNG. */
export const PNG_MARK: readonly number[] = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

export const isPng = (bytes: Uint8Array): boolean => PNG_MARK.every((byte, i) => bytes[i] === byte);

interface Chunk {
  /** of four letters */
  type: string;
  /** cut short where the file ends before the chunk does */
  data: Uint8Array;
}

/** The chunks of a PNG, up to the first that does not begin within the file. */
export function* pngChunks(bytes: Uint8Array): Generator<Chunk> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = PNG_MARK.length; at + 12 <= bytes.length;) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    yield { type, data: bytes.subarray(at + 8, at + 8 + length) };
    at += 12 + length;
  }
}
