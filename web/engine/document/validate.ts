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
  const report = await validateBytes(bytes, { format: 'glb', maxIssues: 1000, writeTimestamp: false });
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
