/** How folds of two-sided surfaces are shaded. */

import { ShaderChunk } from 'three';

const BY_FACING = 'float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;';

/** Cosine of the angle to the eye below which a normal of the side behind is turned. */
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
 * At the silhouette of a fold, where the side behind shows through between pixels, three.js turns the normal of that side away from the
 * light: a dotted dark line. Here only normals that clearly point away from the eye are turned. Materials drawn from now on have it.
 */
export function shadeFolds(): void {
  ShaderChunk.normal_fragment_begin = ShaderChunk.normal_fragment_begin.replace(BY_FACING, BY_NORMAL);
}
