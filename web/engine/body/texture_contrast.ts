/** How visible an error in texture coordinates is: how steeply the colours of textures change along the surface. */

import type { Document } from '@gltf-transform/core';
import { length3 } from '../core/exact_math';
import type { TriangleMesh } from '../core/core';
import type { Entries } from './attributes';
import { texturesShownBy } from './shown_textures';
import type { ShownTexture } from './shown_textures';

/** The most sample points on all triangles, and along an edge of one triangle. */
const MAX_SAMPLES = 1 << 17;
const MAX_ALONG_EDGE = 16;
/** Channels of each texture: red, green, blue, and alpha where it is visible. */
const CHANNELS = 4;
/** A step from black to white changes three channels, one of alpha as much by itself. */
const SQUARE_OF_STEP = 3;
const STEP_OF_ALPHA = Math.sqrt(SQUARE_OF_STEP);

/** A body with texture coordinates: `uv` per wedge, `wedges` per corner. */
export interface TexturedMesh {
  document: Document;
  mesh: TriangleMesh;
  wedges: Uint32Array;
  uv: Float32Array;
}

/**
 * Per triangle, in [0, 1]: the factor on the squared error of its texture coordinates; null where no texture can be decoded.
 *
 * It is the mean square of the slope of colours around the triangle, in steps from black to white per `stepLength`, and 1 where that is
 * more or not known. The slope is the spread of colours over that of positions, on the triangles at the three vertices: so what lies
 * beside an island of the texture atlas does not count, but what lies on the other side of a seam does.
 */
export function textureWeights(
  { primitives, spanOfTriangle }: Pick<Entries, 'primitives' | 'spanOfTriangle'>,
  textured: TexturedMesh,
  stepLength: number,
): Float32Array | null {
  const shown = primitives.map((primitive) =>
    primitive.getAttribute('TEXCOORD_0') ? texturesShownBy(textured.document, primitive.getMaterial()) : null,
  );
  const most = Math.max(0, ...shown.map((list) => list?.length ?? 0));
  if (most === 0) return null;
  const { triangles } = textured.mesh;
  const moments = new Moments(CHANNELS * most, textured.mesh.positions.length / 3);
  const sampler = new Sampler(textured, moments);
  for (let t = 0; 3 * t < triangles.length; ++t) {
    const list = shown[spanOfTriangle[t]];
    if (list) sampler.look(t, list);
    for (let c = 3 * t; list && c < 3 * t + 3; ++c) moments.addTo(triangles[c]);
  }
  return Float32Array.from({ length: triangles.length / 3 }, (_, t) => {
    if (!shown[spanOfTriangle[t]]) return 1;
    const { colours, positions } = moments.spreadAround(triangles.subarray(3 * t, 3 * t + 3));
    if (colours === 0) return 0;
    return Math.min(1, (colours / positions) * (stepLength * stepLength));
  });
}

/** Area-weighted sums over triangles of 1, colours, squared colours, positions and squared positions. */
class Moments {
  /** of one triangle */
  readonly sums: Float64Array;
  readonly square: number;
  readonly positions: number;
  private readonly ofVertices: Float64Array;

  constructor(
    private readonly colours: number,
    vertices: number,
  ) {
    this.square = 1 + colours;
    this.positions = 2 + colours;
    this.sums = new Float64Array(6 + colours);
    this.ofVertices = new Float64Array(this.sums.length * vertices);
  }

  addTo(vertex: number): void {
    const { sums, ofVertices } = this;
    for (let i = 0, at = sums.length * vertex; i < sums.length; ++i) ofVertices[at + i] += sums[i];
  }

  /** The variances; that of colours is 0 where they differ by rounding alone. */
  spreadAround(vertices: Uint32Array): { colours: number; positions: number } {
    const { sums, ofVertices } = this;
    sums.fill(0);
    for (const v of vertices)
      for (let i = 0, at = sums.length * v; i < sums.length; ++i) sums[i] += ofVertices[at + i];
    if (!(sums[0] > 0)) return { colours: 0, positions: 0 };
    const colours = this.variance(1, this.colours) / SQUARE_OF_STEP;
    return { colours: colours > 1e-9 ? colours : 0, positions: this.variance(this.positions, 3) };
  }

  private variance(first: number, count: number): number {
    const { sums } = this;
    let square = sums[first + count] / sums[0];
    for (let i = first; i < first + count; ++i) square -= (sums[i] / sums[0]) * (sums[i] / sums[0]);
    return Math.max(0, square);
  }
}

/** Samples textures on triangles. */
class Sampler {
  private readonly mostAlongEdge: number;
  /** of the corners of a triangle, in pixels */
  private readonly x = [0, 0, 0];
  private readonly y = [0, 0, 0];

  constructor(
    private readonly textured: TexturedMesh,
    private readonly moments: Moments,
  ) {
    const faces = textured.mesh.triangles.length / 3;
    this.mostAlongEdge = Math.max(1, Math.min(MAX_ALONG_EDGE, Math.floor(Math.sqrt(MAX_SAMPLES / faces))));
  }

  /** Leaves the sums of the triangle in `moments.sums`. */
  look(t: number, textures: ShownTexture[]): void {
    this.moments.sums.fill(0);
    this.addPositions(t);
    textures.forEach((texture, k) => {
      this.project(t, texture);
      this.addColours(texture, 1 + CHANNELS * k);
    });
  }

  private project(t: number, { pixels: { width, height }, scale, offset }: ShownTexture): void {
    const { wedges, uv } = this.textured;
    for (let c = 0; c < 3; ++c) {
      const at = 2 * wedges[3 * t + c];
      this.x[c] = width * (scale[0] * uv[at] + offset[0]);
      this.y[c] = height * (scale[1] * uv[at + 1] + offset[1]);
    }
  }

  /** Samples at the centroids of n^2 equal parts of the triangle; their edges are about a pixel long unless that takes too many. */
  private addColours(texture: ShownTexture, first: number): void {
    const [[px, qx, rx], [py, qy, ry]] = [this.x, this.y];
    const longest = Math.max(spreadOf(px, qx, rx), spreadOf(py, qy, ry));
    if (!Number.isFinite(longest)) return;
    const n = Math.max(1, Math.min(this.mostAlongEdge, Math.ceil(longest)));
    const share = this.moments.sums[0] / (n * n);
    for (let i = 0; i < n; ++i)
      for (let j = 0; i + j < n; ++j)
        for (let turned = 0; turned < (i + j + 1 < n ? 2 : 1); ++turned) {
          const [a, b] = [(i + (1 + turned) / 3) / n, (j + (1 + turned) / 3) / n];
          const [x, y] = [px + a * (qx - px) + b * (rx - px), py + a * (qy - py) + b * (ry - py)];
          this.addColour(texture, first, { x, y, share });
        }
  }

  private addColour(
    { pixels, isCut }: ShownTexture,
    first: number,
    { x, y, share }: { x: number; y: number; share: number },
  ): void {
    const { width, height, channels, data } = pixels;
    const { sums, square } = this.moments;
    const at = channels * (wrapped(y, height) * width + wrapped(x, width));
    for (let c = 0; c < (isCut ? channels : 3); ++c) {
      const value = (data[at + c] / 255) * (c === 3 ? STEP_OF_ALPHA : 1);
      sums[first + c] += share * value;
      sums[square] += share * value * value;
    }
  }

  /** Adds the area, and the integrals of the position and its square. */
  private addPositions(t: number): void {
    const { positions, triangles } = this.textured.mesh;
    const { sums, positions: first } = this.moments;
    const at = (c: number, axis: number) => positions[3 * triangles[3 * t + c] + axis];
    const edge = (c: number, axis: number) => at(c, axis) - at(0, axis);
    const part = (u: number, v: number) => edge(1, u) * edge(2, v) - edge(1, v) * edge(2, u);
    const area = length3(part(1, 2), part(2, 0), part(0, 1)) / 2;
    sums[0] = area;
    for (let axis = 0; axis < 3; ++axis) {
      const [a, b, c] = [at(0, axis), at(1, axis), at(2, axis)];
      const sum = a + b + c;
      sums[first + axis] = (area * sum) / 3;
      sums[first + 3] += (area * (a * a + b * b + c * c + sum * sum)) / 12;
    }
  }
}

const spreadOf = (a: number, b: number, c: number): number => Math.max(a, b, c) - Math.min(a, b, c);

/** The index in [0, size) of a coordinate of a repeating texture. */
function wrapped(value: number, size: number): number {
  const rest = Math.floor(value) % size;
  return rest < 0 ? rest + size : rest;
}
