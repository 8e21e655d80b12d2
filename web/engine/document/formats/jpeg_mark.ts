/** The first bytes of every JPEG file (ISO/IEC 10918-1, annex B): the start of an image, then another marker. */
const JPEG_MARK: readonly number[] = [0xff, 0xd8, 0xff];

export const isJpeg = (bytes: Uint8Array): boolean => JPEG_MARK.every((byte, i) => bytes[i] === byte);
