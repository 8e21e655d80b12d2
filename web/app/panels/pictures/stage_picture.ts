/** The stage as a picture of any size, with its ground and its legend. */

import type { Viewport } from '../../viewer/viewport';
import { drawLegend } from './legend_drawing';
import { pictures } from './pictures_state';
import type { SizeName } from './pictures_state';
import { say } from '../../language/say';

export interface PictureSize {
  /** pixels */
  width: number;
  height: number;
  /** pixels per CSS pixel */
  scale: number;
}

/** Pixels of the width and height of a picture. */
export const PIXELS = { least: 16, most: 8192 };
const WIDTH_OF_4K = 3840;

const stageCanvas = (): HTMLCanvasElement => document.querySelector<HTMLCanvasElement>('.viewport canvas')!;

/** Text and dots scale with the picture, so that it looks the same at any size. */
export function sizeOf(name: SizeName): PictureSize {
  const { clientWidth, clientHeight } = stageCanvas();
  const { custom } = pictures;
  if (name === 'custom') {
    const { width, height } = custom.value;
    return { width, height, scale: Math.min(width / clientWidth, height / clientHeight) };
  }
  const scale = name === '4k' ? WIDTH_OF_4K / clientWidth : name === '2x' ? 2 : 1;
  return { width: Math.round(scale * clientWidth), height: Math.round(scale * clientHeight), scale };
}

export interface StageMoment {
  /** rotation of the eye in radians; absent: 0 */
  angle?: number;
  /** that pass before the picture, for animations; absent: 0 */
  seconds?: number;
}

/** Draws the stage onto a canvas of the size of the picture. Throws if the graphics card cannot draw that size. */
export function drawStage(
  viewport: Viewport,
  { width, height, scale }: PictureSize,
  { isTransparent, hasLegend, ...moment }: { isTransparent: boolean; hasLegend: boolean } & StageMoment,
): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext('2d');
  if (!context)
    throw new Error(
      say('A picture of {width} x {height} pixels is too large: choose a smaller one.', { width, height }),
    );
  if (!isTransparent) drawGround(context);
  viewport.capture({ width, height, scale, hasAxes: hasLegend, ...moment }, (stage) =>
    context.drawImage(stage, 0, 0, width, height),
  );
  if (hasLegend) drawLegend(context, scale);
  return canvas;
}

/** As --viewport-ground in styles/tokens.css: an ellipse of 120 % by 90 % around a point in the upper half. */
function drawGround(context: CanvasRenderingContext2D): void {
  const { width, height } = context.canvas;
  const style = getComputedStyle(document.documentElement);
  const gradient = context.createRadialGradient(0, 0, 0, 0, 0, 1);
  gradient.addColorStop(0, style.getPropertyValue('--viewport-high').trim());
  gradient.addColorStop(1, style.getPropertyValue('--viewport-low').trim());
  context.save();
  context.translate(0.5 * width, 0.3 * height);
  context.scale(1.2 * width, 0.9 * height);
  context.fillStyle = gradient;
  context.fillRect(-1, -1, 2, 2);
  context.restore();
}

/** The canvas as a PNG file. */
export async function pngOf(canvas: HTMLCanvasElement): Promise<Uint8Array> {
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!blob) throw new Error(say('The picture is too large to be saved: choose a smaller one.'));
  return new Uint8Array(await blob.arrayBuffer());
}
