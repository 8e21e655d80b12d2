// Filters the light of three.js's plain room once, so that pages need not: writes web/app/viewer/room_light.bin. Must
// be run again after three.js changes its room or its filtering. Usage: node scripts/page/room-light.mjs
//
// The file holds the levels of a cube map one after the other, each with faces of half the width of the one before, and
// of each level the faces +X, -X, +Y, -Y, +Z and -Z: one 32-bit word per texel, the format RGB9_E5 of OpenGL ES 3.0.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import { findChromium, root } from '../setup/environment.mjs';

const target = join(root, 'web', 'app', 'viewer', 'room_light.bin');
/** Texels along an edge of the sharpest level. */
const SIZE = 64;
/** Radians. */
const BLUR = 0.04;
const ORIGIN = 'https://three.test/';

const page = `<script type="importmap">{ "imports": { "three": "/build/three.module.js" } }</script>
<script type="module">
  import * as THREE from 'three';
  import { RoomEnvironment } from '/examples/jsm/environments/RoomEnvironment.js';
  Object.assign(window, { THREE, RoomEnvironment });
</script>`;

/** Runs in the browser. Returns for each level, for each face, red, green, blue and alpha of each texel. */
function filterRoom({ size, blur }) {
  const { THREE, RoomEnvironment } = window;
  /** Filters the room at full size into a cube map of a smaller size. */
  class SmallGenerator extends THREE.PMREMGenerator {
    _allocateTarget() {
      const full = this._cubeSize;
      this._cubeSize = size;
      const small = super._allocateTarget();
      this._cubeSize = full;
      return small;
    }
  }
  const renderer = new THREE.WebGLRenderer();
  const { texture } = new SmallGenerator(renderer).fromScene(new RoomEnvironment(), blur);
  const gl = renderer.getContext();
  const cube = renderer.properties.get(texture).__webglTexture;
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const face = (level, number) => {
    const width = size >> level;
    const side = gl.TEXTURE_CUBE_MAP_POSITIVE_X + number;
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, side, cube, level);
    const texels = new Float32Array(4 * width * width);
    gl.readPixels(0, 0, width, width, gl.RGBA, gl.FLOAT, texels);
    return [...texels];
  };
  return texture.mipmaps.map((_, level) => [0, 1, 2, 3, 4, 5].map((number) => face(level, number)));
}

/** One colour as RGB9_E5: OpenGL ES 3.0, section 3.8.3.2. */
function packColour(red, green, blue) {
  const most = Math.max(red, green, blue);
  if (most <= 0) return 0;
  let exponent = Math.max(-16, Math.floor(Math.log2(most))) + 16;
  if (Math.round(most / 2 ** (exponent - 24)) === 512) exponent++;
  const [r, g, b] = [red, green, blue].map((value) => Math.round(value / 2 ** (exponent - 24)));
  return ((exponent << 27) | (b << 18) | (g << 9) | r) >>> 0;
}

/**
 * Unlike rendered cube maps, loaded ones are looked up mirrored at the YZ plane: both X faces are swapped, and every
 * face is mirrored.
 */
const LOADED_ORDER = [1, 0, 2, 3, 4, 5];

function packFace(texels) {
  const width = Math.sqrt(texels.length / 4);
  return Array.from({ length: width * width }, (_, i) => {
    const column = i % width;
    const at = 4 * (i - column + (width - 1 - column));
    return packColour(texels[at], texels[at + 1], texels[at + 2]);
  });
}

const browser = await chromium.launch({
  executablePath: findChromium(),
  args: ['--enable-unsafe-swiftshader'],
});
const tab = await browser.newPage();
await tab.route(`${ORIGIN}**`, (route) => {
  const path = new URL(route.request().url()).pathname;
  if (path === '/') return route.fulfill({ contentType: 'text/html', body: page });
  return route.fulfill({ path: join(root, 'node_modules', 'three', path), contentType: 'text/javascript' });
});
await tab.goto(ORIGIN);
await tab.waitForFunction(() => 'RoomEnvironment' in window);
const levels = await tab.evaluate(filterRoom, { size: SIZE, blur: BLUR });
await browser.close();
const words = levels.flatMap((faces) => LOADED_ORDER.flatMap((number) => packFace(faces[number])));
writeFileSync(target, Uint32Array.from(words));
console.log(`${target}: ${levels.length} levels, ${4 * words.length} bytes`);
