/** Parts of the JSON of a glTF file whose form is not known. */

export type Json = Record<string, unknown>;

/** Whether a value is an object or a list. */
export const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null;
