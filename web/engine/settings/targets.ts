/** Rules for the values of targets, which are not settings. */

export interface ValueRule {
  isAllowed: (value: unknown) => boolean;
  /** what is allowed, as after "give" */
  words: string;
}

/** The most faces that may be left. */
export const FACE_COUNT: ValueRule = {
  isAllowed: (value) => Number.isInteger(value) && Number(value) >= 1,
  words: 'a whole number of at least 1',
};

/** The share of faces that is left. */
export const FACE_SHARE: ValueRule = {
  isAllowed: (value) => typeof value === 'number' && value > 0 && value <= 1,
  words: 'a number above 0 and up to 1',
};

export const SWITCH: ValueRule = {
  isAllowed: (value) => typeof value === 'boolean',
  words: 'true or false',
};
