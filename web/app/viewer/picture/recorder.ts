/** Records canvases as a WebM video, each at a given time: no frame is lost, however long drawing takes. */

import { webmFile } from './webm';
import type { EncodedFrame } from './webm';

/** The codec's names in WebCodecs and in Matroska. */
const CODEC = { name: 'vp8', matroska: 'V_VP8' };
const BITS_PER_PIXEL = 0.25;
/** Frames from one key frame to the next. */
const KEY_EVERY = 60;
/** Frames that wait for the encoder, at most. */
const MAX_WAITING = 4;

export interface RecordedSize {
  width: number;
  height: number;
  /** frames per second */
  rate: number;
}

/** Makes a video of canvases. */
export interface FrameRecorder {
  /** Adds the next frame; resolves when there is room for another one. */
  add(canvas: HTMLCanvasElement): Promise<void>;
  /** The file. The recorder must not be used afterwards. */
  finish(): Promise<Uint8Array>;
  /** Aborts an unfinished video. */
  cancel(): void;
}

export class Recorder implements FrameRecorder {
  private readonly frames: EncodedFrame[] = [];
  private count = 0;
  private failure: Error | null = null;
  private readonly encoder: VideoEncoder;

  /** Width and height must be even. Throws if the browser cannot encode video. */
  static async open(size: RecordedSize): Promise<Recorder> {
    const { width, height, rate } = size;
    const bitrate = Math.round(BITS_PER_PIXEL * width * height * rate);
    const config = { codec: CODEC.name, width, height, bitrate, framerate: rate };
    const isKnown = typeof VideoEncoder !== 'undefined';
    if (!isKnown || !(await VideoEncoder.isConfigSupported(config)).supported)
      throw new Error(
        `This browser cannot encode a video of ${width} x ${height} pixels: use a current Chrome, Edge, Firefox or Safari, or a smaller size.`,
      );
    const recorder = new Recorder(size);
    recorder.encoder.configure(config);
    return recorder;
  }

  private constructor(private readonly size: RecordedSize) {
    this.encoder = new VideoEncoder({
      output: (chunk) => this.take(chunk),
      error: (error) => (this.failure = error),
    });
  }

  private take(chunk: EncodedVideoChunk): void {
    const bytes = new Uint8Array(chunk.byteLength);
    chunk.copyTo(bytes);
    this.frames.push({ bytes, milliseconds: chunk.timestamp / 1000, isKey: chunk.type === 'key' });
  }

  async add(canvas: HTMLCanvasElement): Promise<void> {
    const { rate } = this.size;
    const timestamp = Math.round((1e6 * this.count) / rate);
    const frame = new VideoFrame(canvas, { timestamp, duration: Math.round(1e6 / rate) });
    this.encoder.encode(frame, { keyFrame: this.count % KEY_EVERY === 0 });
    frame.close();
    this.count += 1;
    do await new Promise((resolve) => setTimeout(resolve));
    while (this.encoder.encodeQueueSize > MAX_WAITING && !this.failure);
    if (this.failure) throw this.failure;
  }

  async finish(): Promise<Uint8Array> {
    const { width, height, rate } = this.size;
    await this.encoder.flush();
    this.encoder.close();
    const milliseconds = (1000 * this.count) / rate;
    return webmFile({ width, height, codec: CODEC.matroska, milliseconds }, this.frames);
  }

  cancel(): void {
    if (this.encoder.state !== 'closed') this.encoder.close();
  }
}
