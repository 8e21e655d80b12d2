/** Estimates the remaining time of the running work from its progress. */

import { say } from '../language/say';
import type { CallProgress } from '../worker/protocol';

/** No time is told before so much is done, as it would be a guess. */
const MIN_DONE = 0.08;
/** s; less is not worth reading */
const MIN_SECONDS = 3;
/** Progress is looked at this often, in s. */
const EVERY = 0.5;
/** The times that the last looks lead to differ by at most this factor, otherwise none is told. */
const MAX_SPREAD = 1.5;
const LOOKS = 3;

/** 0..1 of the work on all bodies, or of the phase of a single one; null if unknown. */
export function shareDone(progress: CallProgress | null): number | null {
  if (!progress) return null;
  const { share, fraction, phase } = progress;
  if (share !== undefined) return share;
  return phase === 'idle' ? null : fraction;
}

/**
 * Remaining seconds of one phase, extrapolated from the completed share. Must be called often with the seconds since
 * the start of the phase and the share, 0..1; null: unknown, not yet stable, or too short to be shown.
 */
export function remainingTime(): (seconds: number, share: number | null) => number | null {
  /** the estimated ends of the phase from the last samples, in s after its start */
  let ends: number[] = [];
  let lookedAt = -Infinity;
  return (seconds, share) => {
    // A new phase has begun.
    if (seconds < lookedAt) [ends, lookedAt] = [[], -Infinity];
    if (share === null || share < MIN_DONE) return null;
    if (seconds - lookedAt >= EVERY) {
      ends = [...ends, seconds / share].slice(-LOOKS);
      lookedAt = seconds;
    }
    const isStable = ends.length === LOOKS && Math.max(...ends) <= MAX_SPREAD * Math.min(...ends);
    const left = ends.reduce((sum, end) => sum + end, 0) / ends.length - seconds;
    return isStable && left >= MIN_SECONDS ? left : null;
  };
}

/** ", 40 s left"; '' if it is unknown or too short to be shown. */
export function describeLeft(seconds: number | null): string {
  if (seconds === null || seconds < MIN_SECONDS) return '';
  return seconds < 90
    ? say(', {seconds} s left', { seconds: Math.round(seconds) })
    : say(', {minutes} min left', { minutes: Math.round(seconds / 60) });
}
