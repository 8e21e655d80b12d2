import { standing, type Shape } from '../shape';
import { clothEnergy, type Cloth } from './energy';
import { minimise } from './minimise';

const side = 33;
const width = 1.6;
/** Distance between the two pinned corners, metres; it is less than the cloth's width, which causes the folds. */
const span = 1.15;

const cloth: Cloth = {
  side,
  cell: width / (side - 1),
  stretch: 900,
  shear: 120,
  bending: 5e-4,
  density: 0.25,
  pins: [0, side - 1],
};

/** Largest net force on a vertex at rest, newtons: 1 % of a vertex's weight. */
const largestForce = 6e-5;

/**
 * A square cloth of 33 x 33 vertices (2,048 faces) at rest, hung by its two top corners: the minimum of its elastic
 * and potential energy. Vertex i + 33 j is i-th from the left and j-th from the top. It has one boundary loop.
 */
export function makeCloth(): Shape {
  const x = startingFolds();
  const force = minimise(clothEnergy(cloth), x, { tolerance: largestForce, iterations: 20000 });
  if (force > largestForce)
    throw new Error(`The cloth did not come to rest: ${force} N are left on a vertex.`);
  return standing(x, gridTriangles());
}

/** The initial cloth, hanging straight down in uneven folds, so that it leaves the symmetric state to one side. */
function startingFolds(): Float64Array {
  const x = new Float64Array(3 * side * side);
  for (let j = 0; j < side; j++)
    for (let i = 0; i < side; i++) {
      const [across, down] = [i / (side - 1), j / (side - 1)];
      const fold = 0.09 * Math.sin(7 * Math.PI * across) + 0.03 * Math.sin(4 * Math.PI * across + 2 * down);
      const v = i + side * j;
      x.set([(across - 0.5) * span, -down * width, fold * Math.sin(Math.PI * across)], 3 * v);
    }
  return x;
}

/** Two triangles per cell; diagonals alternate like a chessboard, so that no direction is stiffer. */
function gridTriangles(): number[] {
  const triangles: number[] = [];
  for (let j = 0; j + 1 < side; j++)
    for (let i = 0; i + 1 < side; i++) {
      const v = i + side * j;
      const [a, b, c, d] = [v + side, v + side + 1, v + 1, v];
      triangles.push(...((i + j) % 2 ? [a, b, c, a, c, d] : [a, b, d, b, c, d]));
    }
  return triangles;
}
