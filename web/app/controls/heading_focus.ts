/** Moves the focus to a panel when it opens, and back when it closes. */

import { useEffect, useRef } from 'preact/hooks';
import type { RefObject } from 'preact';

/** Focuses the heading of a panel when it opens; when it closes, the element that was focused before is focused again. */
export function useHeadingFocus(): RefObject<HTMLHeadingElement | null> {
  const heading = useRef<HTMLHeadingElement>(null);
  // Effects run after the panel is painted; by then the focus may have moved.
  const before = useRef(document.activeElement as HTMLElement | null);
  useEffect(() => {
    const panel = heading.current?.closest('aside, section');
    heading.current?.focus({ preventScroll: true });
    return () => {
      const { activeElement: now } = document;
      // If the focus has moved elsewhere meanwhile, it stays there.
      if (now === null || now === document.body || panel?.contains(now)) before.current?.focus();
    };
  }, []);
  return heading;
}
