/** The type of a message table. */

/** English sentence -> translated sentence, with the same placeholders. */
export type MessageTable = Readonly<Record<string, string>>;
