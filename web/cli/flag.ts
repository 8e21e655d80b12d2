/** What the help says of a flag, and how it is read. */

export interface Flag {
  name: string;
  /** what stands for its value in the help; left out: the flag is a switch */
  value?: string;
  help: string;
  group: string;
}
