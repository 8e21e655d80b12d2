/** The Japanese of the page. */

import type { MessageTable } from '../language';

export const JAPANESE: MessageTable = {};
