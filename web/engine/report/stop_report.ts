/** Why the collapses of results stopped where they did. */

import type { FrequencyFinding, GuardFinding, Tried } from '../body/body_result';
import type { PreparedBody } from '../body/prepared_body';
import type { History, Refused } from '../core/core';
import { sum, vertexCount } from '../core/mesh';
import { methodOf } from '../settings/options';
import type { Settings } from '../settings/options';

export interface StopReport {
  reason: 'target' | 'deviation' | 'angle' | 'frequency' | 'exhausted';
  /** remaining edges of the bodies that could not reach their target, counted by their first reason */
  refused: Refused;
  /** present where frequencies were a target: that of the body with the largest error */
  frequency?: FrequencyReport;
  /** the bodies that the deviation limit stopped; absent where there are none */
  guarded?: GuardReport[];
}

/** A body that the deviation limit stopped; % of the diagonal. */
export interface GuardReport extends GuardFinding {
  body: string;
  faces: number;
}

/** The largest error of the first six frequencies, in %. */
export interface FrequencyReport {
  /** the requested largest error */
  limit: number;
  /** the error of the result */
  error: number;
  /** the largest number of faces, below those of the result, whose error is over the limit; absent where there is none */
  beyond?: Tried;
  /** how many face counts were tried in all bodies */
  tried: number;
}

/** The input of stopReport for a body. */
export interface StoppedBody {
  /** without duplicate faces */
  faces: number;
  /** faces that lie on these and are written beside them; absent: none */
  duplicates?: number;
  targetFaces: number;
  history: Pick<History, 'refused' | 'stop'>;
  frequency?: FrequencyFinding | null;
  /** present where the deviation limit stopped it */
  guard?: GuardFinding | null;
  name?: string;
}

/** The number of faces of bodies as written, with duplicates. */
export const writtenFacesOf = (bodies: StoppedBody[]): number =>
  sum(bodies.map(({ faces, duplicates = 0 }) => faces + duplicates));

/** The reason is that of the first body that stopped above its target; `target` where none did. */
export function stopReport(bodies: StoppedBody[]): StopReport {
  const above = bodies.filter(({ faces, targetFaces }) => faces > targetFaces);
  const stuck = above.filter(({ guard, frequency }) => !guard && !frequency?.isBinding);
  const [first] = above as (StoppedBody | undefined)[];
  const guarded = bodies.flatMap(({ guard, faces, name = '' }) =>
    guard ? [{ body: name, faces, ...guard }] : [],
  );
  const findings = bodies.flatMap((body) => (body.frequency ? [{ ...body, frequency: body.frequency }] : []));
  return {
    reason: first ? reasonOf(first) : 'target',
    refused: sumRefused(stuck.map(({ history }) => history.refused)),
    ...(findings.length > 0 ? { frequency: frequencyReport(findings) } : {}),
    ...(guarded.length > 0 ? { guarded } : {}),
  };
}

/** The counts of several bodies together. */
export function sumRefused(all: readonly Refused[]): Refused {
  const total = (key: keyof Refused) => sum(all.map((refused) => refused[key]));
  return {
    topology: total('topology'),
    flip: total('flip'),
    lock: total('lock'),
    angle: total('angle'),
    deviation: total('deviation'),
  };
}

function reasonOf({ frequency, guard, history }: StoppedBody): StopReport['reason'] {
  if (frequency?.isBinding) return 'frequency';
  return guard ? 'deviation' : history.stop;
}

function frequencyReport(bodies: { faces: number; frequency: FrequencyFinding }[]): FrequencyReport {
  const worst = bodies.reduce((most, one) => (one.frequency.error > most.frequency.error ? one : most));
  const { limit, error, tried } = worst.frequency;
  const below = tried.filter((one) => one.error > limit && one.faces < worst.faces);
  const beyond = below.reduce<Tried | null>(
    (most, one) => (most && most.faces >= one.faces ? most : one),
    null,
  );
  return {
    limit,
    error,
    ...(beyond ? { beyond } : {}),
    tried: sum(bodies.map(({ frequency }) => frequency.tried.length)),
  };
}

/** Why it stopped above the target, in words: the share of the remaining edges under each reason. */
export function describeRefused(refused: Refused): string {
  const { topology, flip, lock, angle, deviation } = refused;
  const all = topology + flip + lock + angle + deviation;
  if (all === 0) return 'no edge is left that could collapse';
  const share = (count: number) => `${Math.round((100 * count) / all)} %`;
  return [
    `of the remaining edges ${share(topology)} would change the topology`,
    `${share(flip)} flip a face`,
    `${share(lock)} break a seam, a border or a lock`,
    ...(angle > 0 ? [`${share(angle)} make an angle too small`] : []),
    ...(deviation > 0 ? [`${share(deviation)} move too far from the surface`] : []),
  ].join(', ');
}

/** Whether most of the remaining edges are refused because seams are kept. */
export function isBlockedBySeams(
  { mesh, attributes }: PreparedBody,
  { lock, ...others }: Refused,
  settings: Pick<Settings, 'seams' | 'method'>,
): boolean {
  const hasSeams = attributes.wedgeCount > vertexCount(mesh);
  const isKept = settings.seams === 'keep' && methodOf(settings).keepsAttributes;
  return hasSeams && isKept && lock > sum(Object.values(others));
}
