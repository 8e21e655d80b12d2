/** Eigenvalues of small dense symmetric problems, for reference solutions. */

/** A row-major matrix of `size` x `size`. */
export interface Matrix {
  size: number;
  values: Float64Array;
}

export const zeros = (size: number): Matrix => ({ size, values: new Float64Array(size * size) });

/** All lambda of K x = lambda M x, ascending, for symmetric K and symmetric positive definite M. Overwrites both. */
export function generalisedEigenvalues(stiffness: Matrix, mass: Matrix): number[] {
  factoriseCholesky(mass);
  reduce(stiffness, mass);
  return jacobiEigenvalues(stiffness);
}

/** Cholesky factorisation M = L L^T in the lower triangle. */
function factoriseCholesky({ size, values }: Matrix): void {
  for (let j = 0; j < size; j++)
    for (let i = j; i < size; i++) {
      let sum = values[i * size + j];
      for (let k = 0; k < j; k++) sum -= values[i * size + k] * values[j * size + k];
      if (i === j && !(sum > 0)) throw new Error('The mass matrix is not positive definite.');
      values[i * size + j] = i === j ? Math.sqrt(sum) : sum / values[j * size + j];
    }
}

/** K := L^-1 K L^-T. */
function reduce({ size, values }: Matrix, { values: lower }: Matrix): void {
  const substitute = (first: number, step: number): void => {
    for (let i = 0; i < size; i++) {
      let sum = values[first + i * step];
      for (let k = 0; k < i; k++) sum -= lower[i * size + k] * values[first + k * step];
      values[first + i * step] = sum / lower[i * size + i];
    }
  };
  for (let column = 0; column < size; column++) substitute(column, size);
  for (let row = 0; row < size; row++) substitute(row * size, 1);
}

/** Cyclic Jacobi rotations (Golub and Van Loan, 8.5). */
function jacobiEigenvalues({ size, values }: Matrix): number[] {
  const at = (i: number, j: number) => i * size + j;
  for (let sweep = 0; sweep < 50; sweep++) {
    let outside = 0;
    let inside = 0;
    for (let i = 0; i < size; i++)
      for (let j = 0; j < size; j++)
        if (i === j) inside += values[at(i, i)] ** 2;
        else outside += values[at(i, j)] ** 2;
    if (outside <= 1e-28 * inside) break;
    for (let p = 0; p < size; p++) for (let q = p + 1; q < size; q++) rotate(size, values, p, q);
  }
  return Array.from({ length: size }, (_, i) => values[at(i, i)]).sort((a, b) => a - b);
}

/** Rotates entry (p, q) of a symmetric matrix to 0. */
function rotate(size: number, values: Float64Array, p: number, q: number): void {
  const entry = values[p * size + q];
  if (entry === 0) return;
  const theta = (values[q * size + q] - values[p * size + p]) / (2 * entry);
  const t = Math.sign(theta || 1) / (Math.abs(theta) + Math.hypot(theta, 1));
  const c = 1 / Math.hypot(t, 1);
  const s = t * c;
  for (let k = 0; k < size; k++) {
    const [a, b] = [values[k * size + p], values[k * size + q]];
    values[k * size + p] = c * a - s * b;
    values[k * size + q] = s * a + c * b;
  }
  for (let k = 0; k < size; k++) {
    const [a, b] = [values[p * size + k], values[q * size + k]];
    values[p * size + k] = c * a - s * b;
    values[q * size + k] = s * a + c * b;
  }
}
