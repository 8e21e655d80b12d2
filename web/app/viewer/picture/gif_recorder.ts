/** Records canvases as a GIF, in a worker. */

import { transfer, wrap } from 'comlink';
import type { Remote } from 'comlink';
import type { GifApi } from './gif_worker';
import type { FrameRecorder, RecordedSize } from './recorder';

export class GifRecorder implements FrameRecorder {
  private readonly worker = new Worker(new URL('./gif_worker.ts', import.meta.url), { type: 'module' });
  private readonly remote: Remote<GifApi> = wrap<GifApi>(this.worker);
  private fail: (error: Error) => void = () => undefined;
  private readonly failed = new Promise<never>((_, reject) => (this.fail = reject));
  /** the frame that is being encoded */
  private encoding: Promise<void>;

  /** 1000 / rate is a multiple of 10. */
  static open(size: RecordedSize): Promise<GifRecorder> {
    return Promise.resolve(new GifRecorder(size));
  }

  private constructor({ width, height, rate }: RecordedSize) {
    this.failed.catch(() => undefined);
    this.worker.addEventListener('error', ({ message }) =>
      this.fail(new Error(`The GIF could not be made: ${message ?? 'its program could not be loaded'}.`)),
    );
    this.encoding = this.remote.open({ width, height, milliseconds: 1000 / rate });
  }

  /** Adds the next frame; resolves when the worker has accepted the previous one. */
  async add(canvas: HTMLCanvasElement): Promise<void> {
    const { width, height } = canvas;
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, width, height);
    await Promise.race([this.encoding, this.failed]);
    this.encoding = this.remote.add(transfer(data, [data.buffer]));
  }

  async finish(): Promise<Uint8Array> {
    await Promise.race([this.encoding, this.failed]);
    return Promise.race([this.remote.finish(), this.failed]);
  }

  cancel(): void {
    this.encoding.catch(() => undefined);
    this.worker.terminate();
  }
}
