/** Divides the canvas between the panes: side by side, on top of each other, or split at a divider. */

import { Vector2 } from 'three';
import type { PaneSize, ScreenPoint } from './seen_vertices';

export type PaneName = 'original' | 'optimized';

/** [left, bottom, width, height] in CSS pixels. */
type Rectangle = [number, number, number, number];

export interface PaneRegion {
  name: PaneName;
  /** the rectangle that the camera's picture fills */
  picture: Rectangle;
  /** the part of the picture that is drawn */
  visible: Rectangle;
}

export class PaneLayout {
  private panes: readonly PaneName[] = ['original'];
  private split: number | null = null;
  /** whether the second pane overlays the first */
  isOverlaid = false;
  /** size of the canvas while a picture of another size is taken, in CSS pixels */
  pictureSize: PaneSize | null = null;

  constructor(private readonly canvas: HTMLCanvasElement) {}

  /** `split` in [0, 1]: the first of two panes is visible to the left of it and the second to the right; null: no divider. */
  arrange(panes: readonly PaneName[], { isOverlaid, split }: { isOverlaid: boolean; split: number | null }) {
    this.panes = panes;
    this.isOverlaid = isOverlaid;
    this.split = panes.length === 2 && !isOverlaid ? split : null;
  }

  /** The number of pictures side by side. */
  get columns(): number {
    return this.isOverlaid || this.split !== null ? 1 : this.panes.length;
  }

  /** Of the canvas, in CSS pixels. */
  get canvasSize(): PaneSize {
    return this.pictureSize ?? { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
  }

  get paneSize(): PaneSize {
    const { width, height } = this.canvasSize;
    return { width: width / this.columns, height };
  }

  columnAt(clientX: number): number {
    const { left, width } = this.canvas.getBoundingClientRect();
    const column = Math.floor(((clientX - left) / width) * this.columns);
    return Math.min(this.columns - 1, Math.max(0, column));
  }

  /** The column at a point of the page: left edge, width and height. */
  columnRegion({ clientX }: { clientX: number }): [number, number, number] {
    const { width, height } = this.canvas.getBoundingClientRect();
    const share = width / this.columns;
    return [this.columnAt(clientX) * share, share, height];
  }

  paneAt(clientX: number): PaneName {
    const { left, width } = this.canvas.getBoundingClientRect();
    if (this.split !== null) return this.panes[(clientX - left) / width < this.split ? 0 : 1];
    return this.panes[this.columnAt(clientX)];
  }

  /** A point of the page in normalised device coordinates of the column that contains `fromX`. */
  deviceCoordinates(clientX: number, clientY: number, fromX: number): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    const across = ((clientX - box.left) / box.width) * this.columns - this.columnAt(fromX);
    return new Vector2(2 * across - 1, 1 - (2 * (clientY - box.top)) / box.height);
  }

  /** A point of the page, measured from the upper left corner of a pane. */
  toPane(name: PaneName, { x, y }: ScreenPoint): ScreenPoint {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: x - left - this.leftOf(name), y: y - top };
  }

  /** A point of a pane, measured from the upper left corner of the canvas. */
  toCanvas(name: PaneName, { x, y }: ScreenPoint): ScreenPoint {
    return { x: x + this.leftOf(name), y };
  }

  private leftOf(name: PaneName): number {
    return this.columns === 1 ? 0 : this.panes.indexOf(name) * this.paneSize.width;
  }

  /** The rectangles of the panes, in drawing order. */
  regions(): PaneRegion[] {
    const { width, height } = this.paneSize;
    const divider = this.split === null ? null : Math.round(this.split * width);
    return this.panes.map((name, i) => {
      const picture: Rectangle = [this.columns === 1 ? 0 : i * width, 0, width, height];
      if (divider === null) return { name, picture, visible: picture };
      return { name, picture, visible: [i * divider, 0, i === 0 ? divider : width - divider, height] };
    });
  }
}
