/** A stroke of the brush or of the pick tool. */
export interface Stroke {
  /** the vertices that it has touched, each with its least distance from the middle of the brush over the radius */
  readonly vertices: ReadonlyMap<number, number>;
  readonly isErasing: boolean;
  /** whether the pointer has not moved */
  readonly isClick: boolean;
}
