/** The Khronos validator, loaded when it is first needed. */

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

export async function validateGlb(bytes: Uint8Array): Promise<Validation> {
  const { validateBytes } = await import('gltf-validator');
  const report = await validateBytes(bytes, {
    format: 'glb',
    maxIssues: 1000,
    writeTimestamp: false,
    // Images that were not there stay references, which are not followed.
    ignoredIssues: ['IO_ERROR'],
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

/** At most as many characters of the validator's words stand in a sentence. */
const LONGEST = 160;

/** The first error that the validator finds in the JSON of a file, and where; null if it finds none. Buffers are not read. */
export async function firstProblem(json: object): Promise<string | null> {
  try {
    const { validateBytes } = await import('gltf-validator');
    const bytes = new TextEncoder().encode(JSON.stringify(json));
    const { issues } = await validateBytes(bytes, { format: 'gltf', maxIssues: 100, writeTimestamp: false });
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
