/** How results were fitted, in words. */

import type { Fitted, ShapeFitted } from '../core/core';
import { counted } from '../core/words';

/** Describes a fit to the surface. */
export const describeShapeFit = ({ flips }: Pick<ShapeFitted, 'flips'>): string =>
  `fitted to the surface (${counted(flips, 'edge', 'edges')} flipped)`;

/** How large parts were fitted; '' where there are none. */
export function describeLargeFit({ large }: Fitted): string {
  if (large === 0) return '';
  const parts = counted(large, 'part has', 'parts have');
  return `${parts} more than 20,000 vertices, fitted to the modes at half and twice the thickness, in six rounds`;
}

/** Why parts were not fitted; '' where all were. */
export function describeUnfitted({ tooLarge }: Fitted): string {
  if (tooLarge === 0) return '';
  return `${counted(tooLarge, 'part has', 'parts have')} more than 20,000 vertices, of too many in the original to fit`;
}
