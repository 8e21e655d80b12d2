/** Which keys scroll a region of the page that has the focus. */

type Region = Pick<Element, 'scrollWidth' | 'clientWidth' | 'scrollHeight' | 'clientHeight'>;

/** Whether the region has more than it shows in the direction of the key. */
export function scrolls(region: Region, key: string): boolean {
  if (/^Arrow(Left|Right)$/.test(key)) return region.scrollWidth > region.clientWidth;
  return /^(Arrow|Home|End|Page)/.test(key) && region.scrollHeight > region.clientHeight;
}
