/** The textures of looks, drawn when first needed. */

import { CanvasTexture, RepeatWrapping, SRGBColorSpace } from 'three';

let matcap: CanvasTexture | null = null;
let checker: CanvasTexture | null = null;

function drawn(size: number, draw: (context: CanvasRenderingContext2D) => void): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  if (context) draw(context);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** A sphere of warm clay, lit from the upper left, with a cool rim. */
export function matcapTexture(): CanvasTexture {
  return (matcap ??= drawn(256, (context) => {
    context.fillStyle = '#2a2f3a';
    context.fillRect(0, 0, 256, 256);
    const body = context.createRadialGradient(100, 84, 8, 128, 128, 132);
    for (const [at, colour] of [
      [0, '#fff3e6'],
      [0.22, '#e8c3a2'],
      [0.55, '#b07a5a'],
      [0.8, '#5d4038'],
      [0.93, '#4a4a63'],
      [1, '#8fa3c8'],
    ] as const)
      body.addColorStop(at, colour);
    context.fillStyle = body;
    context.fillRect(0, 0, 256, 256);
  }));
}

const CELLS = 8;
const SIZE = 512;

/** A board of lettered cells, in which rotated and mirrored UVs can be recognised. */
export function checkerTexture(): CanvasTexture {
  if (checker) return checker;
  checker = drawn(SIZE, (context) => {
    const cell = SIZE / CELLS;
    context.font = `600 ${cell / 2.6}px sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    for (let row = 0; row < CELLS; row++)
      for (let column = 0; column < CELLS; column++) {
        const hue = (360 * row) / CELLS;
        const isDark = (row + column) % 2 === 0;
        context.fillStyle = `hsl(${hue} 45% ${isDark ? 42 : 78}%)`;
        context.fillRect(column * cell, row * cell, cell, cell);
        context.fillStyle = isDark ? '#ffffff' : '#17212b';
        const text = `${String.fromCharCode(65 + row)}${column + 1}`;
        context.fillText(text, (column + 0.5) * cell, (row + 0.5) * cell);
      }
  });
  checker.wrapS = checker.wrapT = RepeatWrapping;
  checker.flipY = false;
  return checker;
}
