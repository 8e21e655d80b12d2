/** Videos of the stage: once around it, and the motion of the Test step, step by step. */

import { effect } from '@preact/signals';
import { STEP_SECONDS } from '../../../engine/motion/simulation';
import { reset, stepOnce } from '../../state/simulation';
import { view } from '../../state/store';
import { twin } from '../../state/twin';
import { GifRecorder } from '../../viewer/picture/gif_recorder';
import { Recorder } from '../../viewer/picture/recorder';
import type { FrameRecorder, RecordedSize } from '../../viewer/picture/recorder';
import type { Viewport } from '../../viewer/viewport';
import { showTwin } from '../simulate/simulate_view';
import type { PictureJob, VideoFormat } from './pictures_state';
import { pictures } from './pictures_state';
import { drawStage, sizeOf } from './stage_picture';
import type { PictureSize, StageMoment } from './stage_picture';

interface Format {
  /** frames per second; whole steps of a simulation last as long as one */
  rate: number;
  /** With a longer side encoding would take too long, or the file would be too large. */
  mostPixels: number;
  open(size: RecordedSize): Promise<FrameRecorder>;
}

const FORMATS: Record<VideoFormat, Format> = {
  webm: { rate: 30, mostPixels: 1920, open: (size) => Recorder.open(size) },
  gif: { rate: 20, mostPixels: 960, open: (size) => GifRecorder.open(size) },
};
const format = (): Format => FORMATS[pictures.format.value];

/** The chosen size with even sides, which video requires. */
function videoSize(mostPixels: number): PictureSize {
  const { width, height, scale } = sizeOf(pictures.size.value);
  const factor = Math.min(1, mostPixels / Math.max(width, height));
  const even = (value: number): number => 2 * Math.max(8, Math.round((factor * value) / 2));
  return { width: even(width), height: even(height), scale: factor * scale };
}

/** Draws `frames` pictures, each after awaiting `prepare`; null if it was cancelled. */
async function record(
  viewport: Viewport,
  { signal, onProgress }: PictureJob,
  { frames, prepare }: { frames: number; prepare: (frame: number) => Promise<StageMoment | null> },
): Promise<Uint8Array | null> {
  const { rate, mostPixels, open } = format();
  const size = videoSize(mostPixels);
  const recorder = await open({ ...size, rate });
  const hasLegend = pictures.hasLegend.value;
  viewport.isRecording = true;
  try {
    for (let frame = 0; frame < frames && !signal.aborted; frame++) {
      const moment = await prepare(frame);
      if (!moment) break;
      await recorder.add(drawStage(viewport, size, { isTransparent: false, hasLegend, ...moment }));
      onProgress((frame + 1) / frames);
    }
    return signal.aborted ? null : await recorder.finish();
  } finally {
    recorder.cancel();
    viewport.isRecording = false;
  }
}

const frameCount = (): number => Math.max(1, Math.round(format().rate * pictures.seconds.value));

/** One turn around the stage, while animations continue. */
export function recordTurntable(viewport: Viewport, job: PictureJob): Promise<Uint8Array | null> {
  const frames = frameCount();
  const { rate } = format();
  const prepare = (frame: number): Promise<StageMoment> =>
    Promise.resolve({ angle: (2 * Math.PI * frame) / frames, seconds: frame === 0 ? 0 : 1 / rate });
  return record(viewport, job, { frames, prepare });
}

/** The motion of the Test step from its start, in real time however long a step takes to compute. */
export async function recordTest(viewport: Viewport, job: PictureJob): Promise<Uint8Array | null> {
  const steps = Math.round(1 / (format().rate * STEP_SECONDS));
  twin.playing.value = false;
  reset();
  if (!(await frameAfter(-1, job.signal))) return null;
  const prepare = async (frame: number): Promise<StageMoment | null> => {
    for (let step = 0; step < steps && frame > 0; step++) {
      const time = twin.frame.value?.time;
      if (time === undefined) return null;
      stepOnce();
      if (!(await frameAfter(time, job.signal))) return null;
    }
    // The effects that move the bodies and their pins run with the next animation frame, which may come too late.
    showTwin(viewport);
    return {};
  };
  return record(viewport, job, { frames: frameCount(), prepare });
}

/**
 * Waits for a frame later than `time`, which is negative before the first one. Returns whether it has come and more can
 * follow: none comes if the step is left, or if the motion has been restarted. Throws if the motion has failed.
 */
function frameAfter(time: number, signal: AbortSignal): Promise<boolean> {
  let stop = (): void => {};
  return new Promise<boolean>((resolve, reject) => {
    signal.addEventListener('abort', () => resolve(false), { once: true });
    stop = effect(() => {
      const { value: frame } = twin.frame;
      if (twin.failure.value) return reject(new Error(twin.failure.value));
      if (view.step.value !== 'test' || (frame?.time ?? -1) < time) return resolve(false);
      if (frame && frame.time > time) resolve(frame.diverged.length === 0);
    });
  }).finally(() => stop());
}
