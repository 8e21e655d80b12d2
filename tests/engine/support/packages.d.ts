/** Types of packages that bring none. */

declare module 'gltf-validator' {
  interface Report {
    issues: {
      numErrors: number;
      numWarnings: number;
      messages: { code: string; message: string; severity: number; pointer?: string }[];
    };
  }
  export function validateBytes(data: Uint8Array, options?: object): Promise<Report>;
}
