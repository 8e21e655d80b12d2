/** Warnings of a run over a file; equal ones of several bodies can be merged into one line. */

/** A warning about one body. */
export interface BodyWarning {
  body: string;
  /** without a full stop at its end */
  text: string;
  /** the whole line where no other body has the same warning */
  alone: string;
  /** the model of the body, where a run reads several */
  model?: string;
}

export type Warning = string | BodyWarning;

/** The warning of a body; files with one body do not name it. */
export const ofBody = (body: string, text: string, isOneOfMany = true): BodyWarning => ({
  body,
  text,
  alone: isOneOfMany ? `${body}: ${text}` : text,
});

/** The warning of a sentence `Body "NAME" has ...`. */
export function ofSentence(sentence: string): Warning {
  const found = /^Body "(.*)" has (.*)$/s.exec(sentence);
  return found ? { body: found[1], text: found[2], alone: sentence } : sentence;
}

/** The warning with the name of the model that it is about, for a run that reads several. */
export const ofModel = (model: string, warning: Warning): Warning =>
  typeof warning === 'string' ? `${model}: ${warning}` : { ...warning, model };

/** The warning as a line of its own. */
export const lineAlone = (warning: Warning): string =>
  typeof warning === 'string' ? warning : inModel(warning, warning.alone);

/** A text on the body of a warning, after the name of its model where it has one. */
export const inModel = ({ model }: BodyWarning, text: string): string =>
  model === undefined ? text : `${model}: ${text}`;
