/** Where the page finds the core. */

/** Of every version its own, see scripts/page/core_folder.mjs; while the page is developed, that of public/. */
const FOLDER = (import.meta.env.CORE_FOLDER as string | undefined) ?? 'wasm/';

/** The address of its folder, with a final slash. `base`: the address of the page, without its name. */
export const coreFolder = (base: string = document.baseURI): string => new URL(FOLDER, base).href;
