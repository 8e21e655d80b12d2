/** Types of the rows of table.ts, which describe the settings, by the kind of value. */

/** The commands of the command line. */
export const COMMANDS = ['optimize', 'tune', 'modes', 'compare', 'simulate', 'inspect'] as const;
export type Command = (typeof COMMANDS)[number];

/** A section of the help; it also decides which commands take the flag, see commands.ts. */
export type OptionGroup =
  'target' | 'method' | 'motion' | 'material' | 'solver' | 'simulation' | 'output' | 'common';

/** A section of the page's panels that shows every number and switch of its own, in the order of the table. */
export type PageSection = 'method' | 'limits' | 'reduction' | 'modes' | 'material' | 'simulation';

interface Described {
  /** without the dashes */
  flag: string;
  label: string;
  /** one sentence */
  help: string;
  group: OptionGroup;
  /** commands that take the flag besides those that take its group */
  commands?: readonly Command[];
  /** the placeholder of the value in the help; absent: see kinds.ts */
  placeholder?: string;
  /** the section of the page with a slider or a switch for it; absent: the page has a special control, or none */
  page?: PageSection;
  /** It refers to parts of one file, so another file starts with the default. */
  isOfFile?: true;
  /** It is about the reading or purpose of one model, so the page starts with the default when another one is opened. */
  isOfUse?: true;
  /** It is a personal preference for written files, so the page keeps it when another model is opened. */
  isOfPerson?: true;
  /** It describes the machine and changes no result, so links and printed command lines leave it out. */
  isOfMachine?: true;
}

interface Ranged {
  /** smallest and largest value that are accepted; of a list, of each entry */
  min: number;
  max: number;
}

interface Numeric extends Described, Ranged {
  unit?: string;
  /** of a slider */
  step: number;
  /** the range of a slider where the whole range would be impractical; logarithmic: equal steps are equal factors */
  slider?: { min: number; max: number; isLogarithmic?: true };
  default: number;
  /** 0 sets no limit. */
  isOffAtZero?: true;
}

/** One of `choices`. */
export interface ChoiceOption extends Described {
  kind: 'choice';
  choices: readonly string[];
  /** names of choices in earlier versions, and their present names */
  formerly?: Readonly<Record<string, string>>;
  default: string;
}

/** A whole number within [min, max]. */
export interface IntegerOption extends Numeric {
  kind: 'integer';
}

/** A number within [min, max]. */
export interface NumberOption extends Numeric {
  kind: 'number';
}

/** `auto`, `all`, or distinct whole numbers within [min, max]. */
export interface ModesOption extends Described, Ranged {
  kind: 'modes';
  default: 'auto' | 'all';
}

/** A list of numbers within [min, max]. */
export interface NumbersOption extends Described, Ranged {
  kind: 'numbers';
  default: readonly number[];
  /** what an empty list stands for, if it has a meaning */
  emptyMeans?: string;
}

/** Text of a form that has a parser: pin_text.ts, paint_text.ts, collider_text.ts, engine_text.ts; of a name or pattern, any text. */
export interface TextOption<
  Kind extends 'pins' | 'paint' | 'colliders' | 'engine' | 'name' | 'pattern',
> extends Described {
  kind: Kind;
  default: string;
}

/** On or off. */
export interface SwitchOption extends Described {
  kind: 'switch';
  default: boolean;
}

export type OptionSpec =
  | ChoiceOption
  | IntegerOption
  | NumberOption
  | ModesOption
  | NumbersOption
  | TextOption<'pins'>
  | TextOption<'paint'>
  | TextOption<'colliders'>
  | TextOption<'engine'>
  | TextOption<'name'>
  | TextOption<'pattern'>
  | SwitchOption;

export type OptionKind = OptionSpec['kind'];

/** The description of settings of one kind. */
export type OptionOf<Kind extends OptionKind> = Extract<OptionSpec, { kind: Kind }>;

interface ValueOfKind {
  integer: number;
  number: number;
  modes: 'auto' | 'all' | readonly number[];
  numbers: readonly number[];
  pins: string;
  paint: string;
  colliders: string;
  engine: string;
  name: string;
  pattern: string;
  switch: boolean;
}

/** The type of the value that a row of the table describes. */
export type SettingValue<Row extends { kind: OptionKind }> = Row extends {
  kind: 'choice';
  choices: readonly (infer Choice)[];
}
  ? Choice
  : Row['kind'] extends keyof ValueOfKind
    ? ValueOfKind[Row['kind']]
    : never;
