// Limited-memory BFGS: minimises a smooth function of many variables from its values and gradients.

/** Writes the gradient at `x` to `gradient` and returns the value. */
export type Objective = (x: Float64Array, gradient: Float64Array) => number;

export interface MinimiseOptions {
  /** The search stops when no component of the gradient is larger. */
  tolerance: number;
  iterations: number;
}

interface Step {
  move: Float64Array;
  change: Float64Array;
  /** move . change */
  curvature: number;
}

const memory = 12;

/** Moves `x` to a point whose gradient is at most `tolerance`; returns the largest component left. */
export function minimise(objective: Objective, x: Float64Array, options: MinimiseOptions): number {
  let gradient = new Float64Array(x.length);
  let value = objective(x, gradient);
  let steps: Step[] = [];
  for (let i = 0; i < options.iterations && largest(gradient) > options.tolerance; i++) {
    const direction = descentDirection(gradient, steps);
    const found = lineSearch(objective, x, { value, gradient, direction, isFirst: steps.length === 0 });
    if (!found) {
      if (steps.length === 0) break;
      steps = [];
      continue;
    }
    const move = combined(found.x, x, -1);
    const change = combined(found.gradient, gradient, -1);
    const curvature = dotProduct(move, change);
    if (curvature > 0) steps.push({ move, change, curvature });
    if (steps.length > memory) steps.shift();
    x.set(found.x);
    ({ value, gradient } = found);
  }
  return largest(gradient);
}

/** The two-loop recursion for -H g, where H approximates the inverse Hessian from the last steps. */
function descentDirection(gradient: Float64Array, steps: readonly Step[]): Float64Array {
  const direction = combined(new Float64Array(gradient.length), gradient, -1);
  const factors: number[] = [];
  for (let s = steps.length - 1; s >= 0; s--) {
    factors[s] = dotProduct(steps[s].move, direction) / steps[s].curvature;
    addScaled(direction, steps[s].change, -factors[s]);
  }
  const last = steps[steps.length - 1];
  if (last) {
    const scale = last.curvature / dotProduct(last.change, last.change);
    addScaled(direction, direction, scale - 1);
  }
  steps.forEach((step, s) => {
    const back = dotProduct(step.change, direction) / step.curvature;
    addScaled(direction, step.move, factors[s] - back);
  });
  return direction;
}

interface Search {
  value: number;
  gradient: Float64Array;
  direction: Float64Array;
  isFirst: boolean;
}

/** Finds a step that satisfies the Armijo and weak Wolfe conditions by bisection; undefined if there is none. */
function lineSearch(objective: Objective, x: Float64Array, { value, gradient, direction, isFirst }: Search) {
  const slope = dotProduct(gradient, direction);
  if (slope >= 0) return undefined;
  let [low, high] = [0, Infinity];
  let step = isFirst ? 1e-3 / largest(direction) : 1;
  const trial = { x, gradient: new Float64Array(x.length), value: 0 };
  for (let attempt = 0; attempt < 40; attempt++) {
    trial.x = combined(x, direction, step);
    trial.value = objective(trial.x, trial.gradient);
    if (trial.value > value + 1e-4 * step * slope) high = step;
    else if (dotProduct(trial.gradient, direction) < 0.9 * slope) low = step;
    else return trial;
    step = high === Infinity ? 2 * step : (low + high) / 2;
  }
  return undefined;
}

function largest(values: Float64Array): number {
  let result = 0;
  for (const value of values) result = Math.max(result, Math.abs(value));
  return result;
}

function dotProduct(a: Float64Array, b: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
}

/** Returns a + factor b. */
function combined(a: Float64Array, b: Float64Array, factor: number): Float64Array {
  const sum = a.slice();
  addScaled(sum, b, factor);
  return sum;
}

function addScaled(target: Float64Array, values: Float64Array, factor: number): void {
  for (let i = 0; i < target.length; i++) target[i] += factor * values[i];
}
