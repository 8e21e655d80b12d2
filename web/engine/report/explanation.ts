/** Why a vertex of the result is still there, in words and shares of the cost. */

import { VERDICTS } from '../core/core';
import type { WhyKept } from '../core/core';

export interface Reason {
  text: string;
  /** its share of the total cost, in [0, 1] */
  share: number;
}

export interface Explanation {
  sentence: string;
  /** terms of the cost of its cheapest collapse, largest first */
  reasons: Reason[];
  /** the factor of the keep weights on the cost; 1: no effect */
  keep: number;
}

const TERMS = [
  ['error', 'the surface would move'],
  ['strain', 'it bends here'],
  ['curvature', 'it is curved here'],
  ['quality', 'triangles would get thinner'],
  ['size', 'triangles would get larger'],
] as const;

const REFUSALS: Record<(typeof VERDICTS)[number], string> = {
  legal: '',
  lock: 'a lock, a border or a pin holds it',
  topology: 'the topology would change',
  flip: 'a face would flip',
  angle: 'an angle would get too small',
  deviation: 'the surface would move too far',
};

/** `vertex`: one of the result that `why` is about. */
export function explain(why: WhyKept, vertex: number): Explanation {
  const verdict = VERDICTS[why.verdict[vertex]];
  const cost = TERMS.reduce((total, [key]) => total + why[key][vertex], 0);
  const reasons = TERMS.map(([key, text]) => ({ text, share: cost > 0 ? why[key][vertex] / cost : 0 }))
    .filter(({ share }) => share >= 0.005)
    .sort((a, b) => b.share - a.share);
  const sentence =
    verdict === 'legal'
      ? `${Math.round(100 * shareOfCheaper(why, vertex))} % of the vertices are removed before it.`
      : `It cannot be removed: ${REFUSALS[verdict]}.`;
  return { sentence, reasons, keep: why.keep[vertex] };
}

/** The share of cheaper vertices among those that can be removed. */
function shareOfCheaper(why: WhyKept, vertex: number): number {
  const costOf = (v: number) => TERMS.reduce((total, [key]) => total + why[key][v], 0) * why.keep[v];
  const own = costOf(vertex);
  let [cheaper, legal] = [0, 0];
  why.verdict.forEach((verdict, v) => {
    if (VERDICTS[verdict] !== 'legal') return;
    legal += 1;
    if (costOf(v) < own) cheaper += 1;
  });
  return legal > 0 ? cheaper / legal : 0;
}
