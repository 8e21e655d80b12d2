/** A stroke of the brush or of the pick tool. */
export interface Stroke {
  /** the touched vertices, each with its smallest distance from the centre of the brush over the radius */
  readonly vertices: ReadonlyMap<number, number>;
  readonly isErasing: boolean;
  /** whether the pointer has not moved */
  readonly isClick: boolean;
}
