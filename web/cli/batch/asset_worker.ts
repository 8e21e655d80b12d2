/** The word that a batch starts its processes with, in place of a command. */
export const ASSET_WORKER = '--asset-worker';
