// Generated sheets whose outline is known: { positions, triangles }.

/** Cells of a grid of 1 x 1 cells that `isInside(i, j)` keeps, cut along alternating diagonals. */
function cells(countX, countY, isInside, place) {
  const ids = new Map();
  const positions = [];
  const triangles = [];
  const at = (i, j) => {
    const key = j * (countX + 1) + i;
    if (!ids.has(key)) {
      ids.set(key, ids.size);
      positions.push(...place(i, j));
    }
    return ids.get(key);
  };
  for (let j = 0; j < countY; j++)
    for (let i = 0; i < countX; i++) {
      if (!isInside(i, j)) continue;
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push(...((i + j) % 2 ? [a, b, c, a, c, d] : [a, b, d, b, c, d]));
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** A flat upright cloth, 1.2 x 1, of n x n cells. */
export const flatCloth = (n) =>
  cells(
    n,
    n,
    () => true,
    (i, j) => [(1.2 * i) / n, j / n, 0],
  );

/** A flat letter E, 4 x 5 strokes wide and high, of n x n cells in each stroke. */
export const letterSheet = (n) =>
  cells(
    4 * n,
    5 * n,
    (i, j) => i < n || Math.floor(j / n) % 2 === 0,
    (i, j) => [i / n, j / n, 0],
  );
