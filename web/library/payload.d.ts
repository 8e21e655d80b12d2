/** Modules that the build of the package makes: gzip in base64. */

declare module 'payload:worker' {
  const program: string;
  export default program;
}

declare module 'payload:single' {
  export const glue: string;
  export const wasm: string;
}

declare module 'payload:threads' {
  export const glue: string;
  export const wasm: string;
}

/** Vite: SSR is true if the bundle runs in Node */
interface ImportMeta {
  readonly env: { readonly SSR: boolean };
}
