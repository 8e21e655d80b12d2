/** The focus of a panel that opens over or beside what the user was at. */

import { useEffect, useRef } from 'preact/hooks';
import type { RefObject } from 'preact';

/** Gives the heading of a panel the focus when it opens; when it closes, what had it before gets it back. */
export function useHeadingFocus(): RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  useEffect(() => {
    const before = document.activeElement as HTMLElement | null;
    const panel = heading.current?.closest('aside, section');
    heading.current?.focus({ preventScroll: true });
    return () => {
      const { activeElement: now } = document;
      // Whoever has gone on elsewhere stays there.
      if (now === null || now === document.body || panel?.contains(now)) before?.focus();
    };
  }, []);
  return heading;
}
