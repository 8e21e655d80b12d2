/** Fuzz targets: functions that are called with generated inputs. */

import fc from 'fast-check';
import { Choices, numbers } from './choices';
import { problemOfRefusal } from './refusal';

export interface FuzzTarget {
  name: string;
  /** Calls the product with what `choices` makes of a valid input; may throw what a user may read. */
  run(choices: Choices): void | Promise<void>;
}

export interface FuzzResult {
  target: string;
  inputs: number;
  seconds: number;
  /** '' where every promise was kept; otherwise what was broken, and how to see it again */
  finding: string;
}

export interface FuzzOptions {
  seed: number;
  seconds: number;
  /** at most so many inputs */
  inputs?: number;
}

/** A single input may take this much time of a processor before it counts as a hang. */
const MAX_SECONDS = 60;

/** The time that this program has had on processors: waiting for one is not the fault of an input. */
function usedSeconds(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}

/** Runs a target again and again with new choices until the time or the number of inputs is used up. */
export async function fuzzTarget(
  target: FuzzTarget,
  { seed, seconds, inputs = 1e9 }: FuzzOptions,
): Promise<FuzzResult> {
  const start = performance.now();
  const property = fc.asyncProperty(numbers, async (drawn) => {
    const began = usedSeconds();
    try {
      await target.run(new Choices(drawn));
    } catch (error) {
      const problem = problemOfRefusal(error);
      if (problem !== null) throw new Error(problem);
    }
    const took = usedSeconds() - began;
    if (took > MAX_SECONDS) throw new Error(`took ${took.toFixed(1)} s`);
  });
  const found = await fc.check(property, {
    seed,
    numRuns: inputs,
    interruptAfterTimeLimit: seconds * 1000,
    markInterruptAsFailure: false,
  });
  return {
    target: target.name,
    inputs: found.numRuns,
    seconds: (performance.now() - start) / 1000,
    finding: found.failed ? describeFinding(found.errorInstance, found.counterexample) : '',
  };
}

/** What is wrong, and the choices that show it. */
const describeFinding = (error: unknown, example: unknown): string =>
  `${error instanceof Error ? error.message : String(error)} (choices ${JSON.stringify(example)})`;
