/** Rewords what a reader throws for the user, who should never see an internal message. */

/** Whether a message was written for the user: readers throw plain Errors with one sentence. */
export const isSentence = (error: unknown): error is Error =>
  error instanceof Error && error.constructor === Error;

/** Runs a reader; anything that it throws besides its own sentences becomes one that names the file and the cure. */
export async function readSafely<T>(name: string, read: () => T | Promise<T>): Promise<T> {
  try {
    return await read();
  } catch (error) {
    throw isSentence(error) ? error : new Error(`${name} cannot be read: ${describeFailure(error)}.`);
  }
}

/** The cause of an internal failure, and the cure, as a clause. */
export function describeFailure(error: unknown): string {
  const message = error instanceof Error ? error.message : '';
  if (/allocation|array length|array buffer|out of memory/i.test(message))
    return 'it asks for more memory than there is: split it into several files';
  if (/call stack/i.test(message)) return 'it is nested too deeply: export it again';
  return 'its parts contradict each other: export it again';
}
