/** At most `count` roots of a continuous function on (from, to), ascending, found by sign changes between steps. */
export function signChanges(
  f: (x: number) => number,
  from: number,
  to: number,
  steps: number,
  count: number,
) {
  const roots: number[] = [];
  let [x, value] = [from, f(from)];
  for (let i = 1; i <= steps && roots.length < count; i++) {
    const next = from + ((to - from) * i) / steps;
    const nextValue = f(next);
    if (value * nextValue < 0) roots.push(bisect(f, x, next));
    [x, value] = [next, nextValue];
  }
  return roots;
}

function bisect(f: (x: number) => number, from: number, to: number): number {
  const sign = Math.sign(f(from));
  for (let i = 0; i < 80; i++) {
    const middle = (from + to) / 2;
    if (Math.sign(f(middle)) === sign) from = middle;
    else to = middle;
  }
  return (from + to) / 2;
}
