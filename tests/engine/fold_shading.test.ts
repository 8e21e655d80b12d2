// Where three.js changes the line that is replaced, folds have dotted lines again.

import { ShaderChunk } from 'three';
import { expect, test } from 'vitest';
import { shadeFolds } from '../../web/app/viewer/file/fold_shading';

test('the normal of a back side is flipped only if it points away from the eye, and never in flat shading, which has none', () => {
  expect(ShaderChunk.normal_fragment_begin).not.toContain('isSeen');
  shadeFolds();
  const lines = ShaderChunk.normal_fragment_begin.split('\n').map((line) => line.trim());
  const flat = lines.indexOf('#ifdef FLAT_SHADED');
  expect(lines[flat + 1]).toBe('float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;');
  expect(lines.slice(flat + 2, flat + 6).join(' ')).toMatch(
    /#else bool isSeen = gl_FrontFacing \|\| dot.* #endif/,
  );
  expect(lines.filter((line) => line.includes('float faceDirection'))).toHaveLength(2);
});
