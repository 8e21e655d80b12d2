/** The scale of colours by curvature. */

const scales = new WeakMap<Float32Array, number>();

/** The curvature that gets the brightest colour: the 98th percentile, so that a single spike does not hide the rest. */
export function curvatureScale(curvature: Float32Array): number {
  const known = scales.get(curvature);
  if (known !== undefined) return known;
  const { length } = curvature;
  const scale = ranked(curvature, Math.floor(0.98 * (length - 1))) || ranked(curvature, length - 1) || 1;
  scales.set(curvature, scale);
  return scale;
}

/**
 * The value at a rank of the ascending order, found by partitions (Hoare 1961), because sorting a million values would
 * block the page; 0 without values.
 */
export function ranked(values: Float32Array, rank: number): number {
  const parts = values.slice();
  let [low, high] = [0, parts.length - 1];
  while (low < high) {
    const pivot = parts[(low + high) >> 1];
    let [i, j] = [low, high];
    while (i <= j) {
      while (parts[i] < pivot) i++;
      while (parts[j] > pivot) j--;
      if (i > j) break;
      const swapped = parts[i];
      parts[i++] = parts[j];
      parts[j--] = swapped;
    }
    if (rank <= j) high = j;
    else if (rank >= i) low = i;
    else break;
  }
  return parts[rank] ?? 0;
}
