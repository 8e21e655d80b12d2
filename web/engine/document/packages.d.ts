/** Types of packages that have none of their own. */

declare module 'gltf-validator' {
  interface Issue {
    code: string;
    message: string;
    severity: number;
    pointer?: string;
  }
  interface Report {
    issues: { numErrors: number; numWarnings: number; messages: Issue[] };
  }
  export function validateBytes(
    data: Uint8Array,
    options?: {
      format?: string;
      maxIssues?: number;
      writeTimestamp?: boolean;
      ignoredIssues?: string[];
      externalResourceFunction?: (uri: string) => Promise<Uint8Array>;
    },
  ): Promise<Report>;
}

declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  const createDecoder: (options?: { locateFile?: (name: string) => string }) => Promise<unknown>;
  export default createDecoder;
}

declare module 'draco3dgltf/draco_encoder_gltf_nodejs.js' {
  const createEncoder: (options?: {
    locateFile?: (name: string) => string;
  }) => Promise<import('./write/draco_boxes').DracoEncoder>;
  export default createEncoder;
}

/** Vite: the address of a file that is shipped beside the bundle. */
declare module '*?url' {
  const address: string;
  export default address;
}

interface ImportMeta {
  /** Vite: SSR is true if the bundle runs in Node */
  readonly env: { readonly SSR: boolean };
}
