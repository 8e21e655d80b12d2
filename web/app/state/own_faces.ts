/** Kept faces of bodies that have a number of their own, by the number of the body; and their text in a link. */

export type OwnFaces = ReadonlyMap<number, number>;

/** "0:120,3:40": each body with its faces, in the order of the bodies. */
export const ownFacesText = (own: OwnFaces): string =>
  [...own]
    .sort(([a], [b]) => a - b)
    .map(([body, faces]) => `${body}:${faces}`)
    .join(',');

/** Null if the text does not have this form. */
export function readOwnFaces(text: string): OwnFaces | null {
  if (!/^\d{1,9}:\d{1,9}(,\d{1,9}:\d{1,9})*$/.test(text)) return null;
  return new Map(text.split(',').map((pair) => pair.split(':').map(Number) as [number, number]));
}

/** The entries of `own` that fit the bodies of a file; none if nothing is requested. */
export const fittingOwnFaces = (own: OwnFaces | undefined, bodies: { faces: number }[]): OwnFaces =>
  new Map(
    [...(own ?? [])]
      .filter(([body]) => body < bodies.length)
      .map(([body, kept]) => [body, Math.min(Math.max(kept, 1), bodies[body].faces)]),
  );
