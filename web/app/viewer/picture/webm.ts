/** A WebM file of one video track, with the exact time of each frame (Matroska, RFC 9559). */

export interface EncodedFrame {
  bytes: Uint8Array;
  /** since the start of the video */
  milliseconds: number;
  isKey: boolean;
}

export interface VideoTrack {
  width: number;
  height: number;
  /** Matroska's name of the codec, as V_VP8 */
  codec: string;
  /** of the whole video */
  milliseconds: number;
}

/** Identifiers of elements, RFC 9559, section 5. */
const ID = {
  ebml: [0x1a, 0x45, 0xdf, 0xa3],
  ebmlVersion: [0x42, 0x86],
  ebmlReadVersion: [0x42, 0xf7],
  ebmlMaxIdLength: [0x42, 0xf2],
  ebmlMaxSizeLength: [0x42, 0xf3],
  docType: [0x42, 0x82],
  docTypeVersion: [0x42, 0x87],
  docTypeReadVersion: [0x42, 0x85],
  segment: [0x18, 0x53, 0x80, 0x67],
  info: [0x15, 0x49, 0xa9, 0x66],
  timestampScale: [0x2a, 0xd7, 0xb1],
  duration: [0x44, 0x89],
  muxingApp: [0x4d, 0x80],
  writingApp: [0x57, 0x41],
  tracks: [0x16, 0x54, 0xae, 0x6b],
  trackEntry: [0xae],
  trackNumber: [0xd7],
  trackUid: [0x73, 0xc5],
  trackType: [0x83],
  codecId: [0x86],
  video: [0xe0],
  pixelWidth: [0xb0],
  pixelHeight: [0xba],
  cues: [0x1c, 0x53, 0xbb, 0x6b],
  cuePoint: [0xbb],
  cueTime: [0xb3],
  cueTrackPositions: [0xb7],
  cueTrack: [0xf7],
  cueClusterPosition: [0xf1],
  cluster: [0x1f, 0x43, 0xb6, 0x75],
  timestamp: [0xe7],
  simpleBlock: [0xa3],
} as const;

/** Times within a cluster are signed 16-bit numbers. */
const LONGEST_CLUSTER = 30_000;

const join = (parts: readonly Uint8Array[]): Uint8Array => {
  const out = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
};

/** An unsigned integer in `size` bytes, the highest first. */
const integer = (value: number, size: number): Uint8Array =>
  Uint8Array.from({ length: size }, (_, i) => Math.floor(value / 2 ** (8 * (size - 1 - i))) % 256);

const double = (value: number): Uint8Array => {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
};

/** The length of an element: eight bytes, of which the first one encodes that size. */
function lengthOf(value: number): Uint8Array {
  const bytes = integer(value, 8);
  bytes[0] = 1;
  return bytes;
}

function element(name: keyof typeof ID, ...content: Uint8Array[]): Uint8Array {
  const body = join(content);
  return join([Uint8Array.from(ID[name]), lengthOf(body.length), body]);
}

const number = (name: keyof typeof ID, value: number): Uint8Array => element(name, integer(value, 8));
const text = (name: keyof typeof ID, value: string): Uint8Array =>
  element(name, new TextEncoder().encode(value));

/** `frames` must be in order of time and start with a key frame. */
export function webmFile(track: VideoTrack, frames: readonly EncodedFrame[]): Uint8Array {
  const clusters = clustersOf(frames);
  const bodies = clusters.map(clusterElement);
  const head = [infoElement(track), trackElement(track)];
  const headLength = join(head).length;
  const starts = clusters.map(([{ milliseconds }]) => milliseconds);
  // Positions count from the start of the segment's content, with the cues in front; their length does not depend on them.
  const cuesLength = cuesElement(starts, starts).length;
  let position = headLength + cuesLength;
  const positions = bodies.map(({ length }) => (position += length) - length);
  const header = element(
    'ebml',
    ...[number('ebmlVersion', 1), number('ebmlReadVersion', 1), number('ebmlMaxIdLength', 4)],
    ...[number('ebmlMaxSizeLength', 8), text('docType', 'webm'), number('docTypeVersion', 4)],
    number('docTypeReadVersion', 2),
  );
  return join([header, element('segment', ...head, cuesElement(starts, positions), ...bodies)]);
}

/** A cluster begins with each key frame. */
function clustersOf(frames: readonly EncodedFrame[]): EncodedFrame[][] {
  const clusters: EncodedFrame[][] = [];
  for (const frame of frames) {
    const last = clusters.at(-1);
    const isFull = last !== undefined && frame.milliseconds - last[0].milliseconds > LONGEST_CLUSTER;
    if (!last || frame.isKey || isFull) clusters.push([frame]);
    else last.push(frame);
  }
  return clusters;
}

const infoElement = ({ milliseconds }: VideoTrack): Uint8Array =>
  element(
    'info',
    ...[number('timestampScale', 1_000_000), element('duration', double(milliseconds))],
    ...[text('muxingApp', 'Limber'), text('writingApp', 'Limber')],
  );

const trackElement = ({ width, height, codec }: VideoTrack): Uint8Array =>
  element(
    'tracks',
    element(
      'trackEntry',
      ...[number('trackNumber', 1), number('trackUid', 1), number('trackType', 1), text('codecId', codec)],
      element('video', number('pixelWidth', width), number('pixelHeight', height)),
    ),
  );

const cuesElement = (times: readonly number[], positions: readonly number[]): Uint8Array =>
  element(
    'cues',
    ...times.map((time, i) =>
      element(
        'cuePoint',
        number('cueTime', Math.round(time)),
        element('cueTrackPositions', number('cueTrack', 1), number('cueClusterPosition', positions[i])),
      ),
    ),
  );

function clusterElement(frames: readonly EncodedFrame[]): Uint8Array {
  const start = Math.round(frames[0].milliseconds);
  const blocks = frames.map(({ bytes, milliseconds, isKey }) =>
    // The number of the track, the time since the cluster's, and flags.
    element(
      'simpleBlock',
      Uint8Array.of(0x81),
      integer(Math.round(milliseconds) - start, 2),
      Uint8Array.of(isKey ? 0x80 : 0),
      bytes,
    ),
  );
  return element('cluster', number('timestamp', start), ...blocks);
}
