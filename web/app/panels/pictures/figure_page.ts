/** Lays pictures out as a figure: in rows, each with a letter, a title and a line below it. */

import { drawGradient, pageStyle } from './legend_drawing';
import { say } from '../../language/say';

export interface FigurePicture {
  /** all of one size */
  canvas: HTMLCanvasElement;
  title: string;
  detail: string;
  /** whether the strain scale is drawn below */
  hasScale: boolean;
}

/** Pixels. */
const MARGIN = 48;
const GAP = 36;
const CAPTION = 104;
const LETTERS = { title: 30, detail: 26 };
const SCALE = { width: 220, height: 12 };
/** A figure is printed in one row up to so many pictures, and in two beyond. */
const MAX_IN_ROW = 5;

/** A figure is printed on white, so that its colours are those of the light scheme. */
const COLOURS = { ground: '#ffffff', text: '#17212b', muted: '#55636f' };

export function composeFigure(
  pictures: readonly FigurePicture[],
  { isTransparent }: { isTransparent: boolean },
): HTMLCanvasElement {
  const columns = pictures.length > MAX_IN_ROW ? Math.ceil(pictures.length / 2) : pictures.length;
  const rows = Math.ceil(pictures.length / columns);
  const { width, height } = pictures[0].canvas;
  const canvas = document.createElement('canvas');
  canvas.width = 2 * MARGIN + columns * width + (columns - 1) * GAP;
  canvas.height = 2 * MARGIN + rows * (height + CAPTION) + (rows - 1) * GAP;
  const context = canvas.getContext('2d');
  if (!context) throw new Error(say('The figure is too large for this browser.'));
  context.fillStyle = COLOURS.ground;
  if (!isTransparent) context.fillRect(0, 0, canvas.width, canvas.height);
  pictures.forEach((picture, i) => {
    const left = MARGIN + (i % columns) * (width + GAP);
    const top = MARGIN + Math.floor(i / columns) * (height + CAPTION + GAP);
    context.drawImage(picture.canvas, left, top);
    drawCaption(context, picture, { letter: 'abcdefghij'[i], middle: left + width / 2, top: top + height });
  });
  return canvas;
}

function drawCaption(
  context: CanvasRenderingContext2D,
  { title, detail, hasScale }: FigurePicture,
  { letter, middle, top }: { letter: string; middle: number; top: number },
): void {
  const { family } = pageStyle();
  context.textAlign = 'center';
  context.fillStyle = COLOURS.text;
  context.font = `600 ${LETTERS.title}px ${family}`;
  context.fillText(`(${letter}) ${title}`, middle, top + 40);
  context.fillStyle = COLOURS.muted;
  context.font = `400 ${LETTERS.detail}px ${family}`;
  context.fillText(detail, middle, top + 76);
  if (!hasScale) return;
  const { width, height } = SCALE;
  const left = middle - width / 2;
  drawGradient(context, { left, top: top + 92, width, height, map: 'viridis' });
  context.fillStyle = COLOURS.muted;
  context.textAlign = 'right';
  context.fillText('least', left - 10, top + 106);
  context.textAlign = 'left';
  context.fillText('most', left + width + 10, top + 106);
}
