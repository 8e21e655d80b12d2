/** Types of the structure checks, which are plain JavaScript. */

interface ProductFile {
  path: string;
  text: string;
}
type Modules = Record<string, string[]>;

declare module '*/structure/dependencies.mjs' {
  export function wrongDependencies(files: ProductFile[], modules: Modules): string[];
}
declare module '*/structure/cycles.mjs' {
  export function importCycles(files: ProductFile[]): string[];
}
declare module '*/structure/sizes.mjs' {
  export const limits: Record<string, number>;
  export function largeThings(files: ProductFile[]): string[];
  export function percentile(values: number[], part: number): number;
}
declare module '*/structure/type_names.mjs' {
  export function doubleTypeNames(files: ProductFile[]): string[];
}
declare module '*/structure/glossary.mjs' {
  export function struckWords(files: ProductFile[], glossary: string): string[];
}
declare module '*/structure/document_paths.mjs' {
  export function missingPaths(documents: ProductFile[], known: Set<string>): string[];
}
declare module '*/structure/modules.mjs' {
  export const modules: Modules;
}
declare module '*/structure/texts.mjs' {
  export function blankComments(text: string): string;
  export function readProduct(): ProductFile[];
  export function wordsOf(name: string): string[];
}
declare module '*/docs/architecture-picture.mjs' {
  export function drawArchitecture(): string;
}
declare module '*/docs/third-party.mjs' {
  export function thirdParty(): Promise<string>;
}
declare module '*/bench/registry.mjs' {
  export const BENCHES: { name: string; script: string; document: string | null }[];
}
declare module '*/bench/tables.mjs' {
  export function rowsOf(text: string): string[][];
  export function numberOf(cell: string): number;
  export function compareRows(
    before: string[][],
    now: string[][],
  ): { row: string; column: number; before: number; now: number; ratio: number }[];
}
