/** The location of the core for the page. */

/** Every version has its own folder, see scripts/page/core_folder.mjs; in development it is that of public/. */
const FOLDER = (import.meta.env.CORE_FOLDER as string | undefined) ?? 'wasm/';

/** The address of its folder, with a final slash. `base`: the address of the page, without its name. */
export const coreFolder = (base: string = document.baseURI): string => new URL(FOLDER, base).href;
