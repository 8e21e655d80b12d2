/** Phases and progress of the running call. */

/** In the order of `enum class Phase` in wasm/base/job.h. */
export const PHASES = [
  'idle',
  'welding vertices',
  'assembling matrices',
  'factorising',
  'solving for modes',
  'measuring strain',
  'measuring curvature',
  'collapsing edges',
  'measuring distance',
  'comparing modes',
  'fitting',
  'simulating',
  'looking for symmetry',
] as const;

/** Progress of the running call; `fraction` is that of the phase, in [0, 1]. */
export interface Progress {
  phase: (typeof PHASES)[number];
  fraction: number;
}
