/** The Khronos validator, loaded when it is first needed. */

import { sum } from '../core/mesh';
import { grouped } from '../core/words';
import { unpacked } from './archive/read_zip';
import { companionPath } from './checks/companions';
import { isGlb } from './glb';
import type { SourceFile } from './model';

export interface Validation {
  errors: number;
  warnings: number;
  /** errors, then warnings, each with its code and JSON pointer */
  messages: string[];
}

interface ValidatorMessage {
  code: string;
  message: string;
  severity: number;
  pointer?: string;
}

const ERROR = 0;
const WARNING = 1;

export const validateGlb = (bytes: Uint8Array): Promise<Validation> => validate(bytes, 'glb', []);

/** The GLB among the files, or the glTF with the others beside it, also in a ZIP; null for other formats. */
export async function validateFiles(files: SourceFile[]): Promise<Validation | null> {
  const all = unpacked(files);
  const main = all.find(({ name, bytes }) => isGlb(bytes) || /\.gl(b|tf)$/i.test(name)) ?? namelessGltf(all);
  if (!main) return null;
  return validate(main.bytes, isGlb(main.bytes) ? 'glb' : 'gltf', all);
}

/** The first file, which is the model, if it is glTF without an ending in its name. */
const namelessGltf = ([first]: SourceFile[]): SourceFile | null =>
  first && first.bytes[0] === '{'.charCodeAt(0) ? first : null;

/** The errors, each with its code, that `result` has more of than `input`; all of them without an input to compare with. */
export function addedErrors(result: Validation, input: Validation | null): string[] {
  const codeOf = (message: string) => message.replace(/ at .*/s, '');
  const counts = new Map<string, number>();
  for (const message of input?.messages.slice(0, input.errors) ?? [])
    counts.set(codeOf(message), (counts.get(codeOf(message)) ?? 0) + 1);
  return result.messages.slice(0, result.errors).filter((message) => {
    const left = counts.get(codeOf(message)) ?? 0;
    counts.set(codeOf(message), left - 1);
    return left <= 0;
  });
}

/** Larger files are not checked: the validator takes some 60 ms per megabyte, and several times the file's size in memory. */
const MAX_BYTES = 64 * 2 ** 20;
/** The most errors that a sentence lists. */
const ERRORS_SHOWN = 3;

/**
 * The errors that the validator finds in a result and not in its source, in words; null where there is none, where the files are large,
 * and for formats other than glTF.
 */
export async function describeAddedErrors(
  result: SourceFile[],
  source: SourceFile[],
): Promise<string | null> {
  if (sizeOf(result) > MAX_BYTES) return null;
  const found = await validateFiles(result);
  if (!found || found.errors === 0) return null;
  const before = sizeOf(source) > MAX_BYTES ? null : await validateFiles(source);
  const added = addedErrors(found, before);
  if (added.length === 0) return null;
  const shown = added.slice(0, ERRORS_SHOWN).map((message) => message.replace(/\.$/, ''));
  const more = added.length > ERRORS_SHOWN ? `; and ${grouped(added.length - ERRORS_SHOWN)} more` : '';
  return `${shown.join('; ')}${more}`;
}

const sizeOf = (files: SourceFile[]): number => sum(files.map(({ bytes }) => bytes.length));

const importValidator = () => import('gltf-validator');

/** Loads the validator in the background before it is needed; an error shows up when it is used. */
export const loadValidator = (): void => void importValidator().catch(() => undefined);

async function validate(bytes: Uint8Array, format: 'glb' | 'gltf', files: SourceFile[]): Promise<Validation> {
  const { validateBytes } = await importValidator();
  const report = await validateBytes(bytes, {
    format,
    maxIssues: 1000,
    writeTimestamp: false,
    // Missing images stay references, which are not followed.
    ignoredIssues: ['IO_ERROR'],
    externalResourceFunction: (uri) => readCompanion(files, uri),
  });
  const { numErrors, numWarnings, messages } = report.issues;
  const described = (severity: number) =>
    messages
      .filter((issue: ValidatorMessage) => issue.severity === severity)
      .map((issue: ValidatorMessage) => `${issue.code} at ${issue.pointer ?? '/'}: ${issue.message}`);
  return {
    errors: numErrors,
    warnings: numWarnings,
    messages: [...described(ERROR), ...described(WARNING)],
  };
}

function readCompanion(files: SourceFile[], uri: string): Promise<Uint8Array> {
  const path = companionPath('', uri);
  const file = files.find(({ name }) => name === path || name.endsWith(`/${path}`));
  return file ? Promise.resolve(file.bytes) : Promise.reject(new Error('It is not there.'));
}

/** The most characters of the validator's message that a sentence quotes. */
const LONGEST = 160;

/** Errors despite which a file can be read. */
const HARMLESS = ['IO_ERROR', 'ACCESSOR_MIN_MISMATCH', 'ACCESSOR_MAX_MISMATCH'];

/** The first error that the validator finds in the JSON of a file, and where; null if it finds none. Buffers are not read. */
export async function firstProblem(json: object): Promise<string | null> {
  try {
    const { validateBytes } = await importValidator();
    const bytes = new TextEncoder().encode(JSON.stringify(json));
    const { issues } = await validateBytes(bytes, {
      format: 'gltf',
      maxIssues: 100,
      writeTimestamp: false,
      ignoredIssues: HARMLESS,
    });
    const error = issues.messages.find(({ severity }) => severity === ERROR);
    if (!error) return null;
    return `${error.message.replace(/\.$/, '').replace(/\. /g, ': ')} at ${error.pointer ?? '/'}`.slice(
      0,
      LONGEST,
    );
  } catch {
    return null;
  }
}
