/** The keys that scroll the focused region of the page. */

type Region = Pick<Element, 'scrollWidth' | 'clientWidth' | 'scrollHeight' | 'clientHeight'>;

/** Whether the region can scroll further in the direction of the key. */
export function scrolls(region: Region, key: string): boolean {
  if (/^Arrow(Left|Right)$/.test(key)) return region.scrollWidth > region.clientWidth;
  return /^(Arrow|Home|End|Page)/.test(key) && region.scrollHeight > region.clientHeight;
}
