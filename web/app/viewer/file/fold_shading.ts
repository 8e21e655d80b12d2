/** The shading of folds of two-sided surfaces. */

import { ShaderChunk } from 'three';

const BY_FACING = 'float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;';

/** Cosine of the angle to the eye below which a normal of the back side is flipped. */
const TURNED = '-0.15';

const BY_NORMAL = `
#ifdef FLAT_SHADED
  ${BY_FACING}
#else
  bool isSeen = gl_FrontFacing || dot( normalize( vNormal ), normalize( vViewPosition ) ) > ${TURNED};
  float faceDirection = isSeen ? 1.0 : - 1.0;
#endif
`;

/**
 * At the silhouette of a fold, where the back side shows through between pixels, three.js flips the normal of that side
 * away from the light, which gives a dotted dark line. Here only normals that clearly point away from the eye are
 * flipped. Applies to materials compiled from now on.
 */
export function shadeFolds(): void {
  ShaderChunk.normal_fragment_begin = ShaderChunk.normal_fragment_begin.replace(BY_FACING, BY_NORMAL);
}
