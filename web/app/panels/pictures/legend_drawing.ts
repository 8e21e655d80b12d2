/** Draws the legend of the stage into a picture: the names of the panes and the meaning of the colours. */

import { isSplit } from '../reduce/compare';
import { shownField, view } from '../../state/store';
import { colourAt } from '../../viewer/colours';

/** The current text and colours of the page. */
export interface PageStyle {
  text: string;
  muted: string;
  family: string;
}

export function pageStyle(): PageStyle {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string): string => style.getPropertyValue(name).trim();
  return {
    text: read('--text'),
    muted: read('--muted'),
    family: getComputedStyle(document.body).fontFamily,
  };
}

/** The labels next to a colour map. */
interface Bar {
  low: string;
  title: string;
  high: string;
}

const STOPS = 32;

const texts = (selector: string): string[] =>
  [...document.querySelectorAll<HTMLElement>(selector)].map((one) => one.textContent.trim());

/** The names as shown over the stage: the first part bold, the rest muted. */
function paneNames(): { name: string; detail: string }[] {
  return [...document.querySelectorAll<HTMLElement>('.pane-labels > span')].map((label) => {
    const detail = label.querySelector('.muted')?.textContent ?? '';
    return { name: label.textContent.replace(detail, '').trim(), detail: detail.trim() };
  });
}

function shownBar(): Bar | null {
  const parts = texts('.legend .bar .ends > span');
  return parts.length === 3 ? { low: parts[0], title: parts[1], high: parts[2] } : null;
}

/** `scale`: pixels per CSS pixel. */
export function drawLegend(context: CanvasRenderingContext2D, scale: number): void {
  const style = pageStyle();
  const { width } = context.canvas;
  const names = paneNames();
  context.textBaseline = 'alphabetic';
  names.forEach(({ name, detail }, i) => {
    drawName(context, { name, detail, style, scale, middle: (width * (i + 0.5)) / names.length });
  });
  const bar = shownBar();
  if (bar) drawBar(context, bar, { style, scale });
  if (isSplit()) {
    context.fillStyle = style.muted;
    context.fillRect(view.split.value * width - scale / 2, 0, scale, context.canvas.height);
  }
}

interface NameDrawing {
  name: string;
  detail: string;
  style: PageStyle;
  scale: number;
  /** pixels from the left edge */
  middle: number;
}

function drawName(context: CanvasRenderingContext2D, drawing: NameDrawing): void {
  const { name, detail, style, scale, middle } = drawing;
  const [bold, plain] = [`600 ${14 * scale}px ${style.family}`, `400 ${14 * scale}px ${style.family}`];
  const widthIn = (font: string, text: string): number => {
    context.font = font;
    return context.measureText(text).width;
  };
  const gap = 6 * scale;
  const left = middle - (widthIn(bold, name) + gap + widthIn(plain, detail)) / 2;
  context.textAlign = 'left';
  context.font = bold;
  context.fillStyle = style.text;
  context.fillText(name, left, 28 * scale);
  const after = left + context.measureText(name).width + gap;
  context.font = plain;
  context.fillStyle = style.muted;
  context.fillText(detail, after, 28 * scale);
}

const shownMap = () =>
  shownField.value === 'curvature' && view.step.value !== 'test'
    ? ('cividis' as const)
    : ('viridis' as const);

function drawBar(
  context: CanvasRenderingContext2D,
  { low, title, high }: Bar,
  { style, scale }: { style: PageStyle; scale: number },
): void {
  const width = Math.min(300 * scale, 0.6 * context.canvas.width);
  const [left, top] = [(context.canvas.width - width) / 2, context.canvas.height - 26 * scale];
  drawGradient(context, { left, top, width, height: 8 * scale, map: shownMap() });
  context.font = `400 ${12 * scale}px ${style.family}`;
  const write = (text: string, align: CanvasTextAlign, x: number, colour: string): void => {
    context.textAlign = align;
    context.fillStyle = colour;
    context.fillText(text, x, top - 6 * scale);
  };
  write(low, 'left', left, style.muted);
  write(title, 'center', left + width / 2, style.text);
  write(high, 'right', left + width, style.muted);
}

interface GradientBox {
  left: number;
  top: number;
  width: number;
  height: number;
  map: 'viridis' | 'cividis';
}

export function drawGradient(context: CanvasRenderingContext2D, box: GradientBox): void {
  const { left, top, width, height, map } = box;
  const gradient = context.createLinearGradient(left, 0, left + width, 0);
  for (let i = 0; i <= STOPS; i++) gradient.addColorStop(i / STOPS, colourAt(map, i / STOPS));
  context.fillStyle = gradient;
  context.fillRect(left, top, width, height);
}
