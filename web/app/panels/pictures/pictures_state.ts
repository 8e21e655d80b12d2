/** The state of the pictures panel: the requested picture, and the one being drawn. */

import { signal } from '@preact/signals';
import { pictureName } from '../../state/export_request';
import { complain } from '../../state/running';
import { download } from '../../files/files';

/** Sizes of a picture: the stage's own times a factor, a width in pixels, or a width and a height. */
export const SIZES = ['1x', '2x', '4k', 'custom'] as const;
export type SizeName = (typeof SIZES)[number];

export type VideoFormat = 'webm' | 'gif';

export const pictures = {
  isOpen: signal(false),
  size: signal<SizeName>('2x'),
  /** pixels, of a custom size */
  custom: signal({ width: 1920, height: 1080 }),
  hasLegend: signal(true),
  isTransparent: signal(false),
  format: signal<VideoFormat>('webm'),
  /** s, of a video */
  seconds: signal(4),
  /** the picture being drawn, and its progress, 0..1 */
  work: signal<{ what: string; share: number } | null>(null),
};

let running: AbortController | null = null;

export const cancelPicture = (): void => running?.abort();

export interface PictureJob {
  signal: AbortSignal;
  onProgress(share: number): void;
}

/** Makes a picture or a video and saves it, one at a time; null: it was cancelled. */
export async function makePicture(
  { what, ending, type }: { what: string; ending: string; type: string },
  make: (job: PictureJob) => Promise<Uint8Array | string | null>,
): Promise<void> {
  if (running) return;
  const own = (running = new AbortController());
  // Another file may be opened meanwhile.
  const name = pictureName(ending);
  const onProgress = (share: number): void => void (pictures.work.value = { what, share });
  onProgress(0);
  try {
    // Shows the progress before the work begins.
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const content = await make({ signal: own.signal, onProgress });
    if (content !== null && !own.signal.aborted) download(name, content, type);
  } catch (error) {
    complain(error);
  } finally {
    running = null;
    pictures.work.value = null;
  }
}
