/** The mark by which a ZIP is recognised as written by Limber. */

/** The id of the extra field of the first entry that holds the mark. */
export const MARK_FIELD = 0x4c4d;

/** Offsets in a local file header of the lengths of its name and extra fields, and of the name itself (APPNOTE 4.3.7). */
const NAME_LENGTH = 26;
const NAME = 30;

/** The mark of an archive that `writeZip` wrote; '' without one. `bytes`: at least the first local file header. */
export function markOfZip(bytes: Uint8Array): string {
  if (bytes.length < NAME) return '';
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = NAME + view.getUint16(NAME_LENGTH, true);
  const end = Math.min(bytes.length, at + view.getUint16(NAME_LENGTH + 2, true));
  while (at + 4 <= end) {
    const [field, length] = [view.getUint16(at, true), view.getUint16(at + 2, true)];
    if (field === MARK_FIELD) return new TextDecoder().decode(bytes.subarray(at + 4, at + 4 + length));
    at += 4 + length;
  }
  return '';
}
