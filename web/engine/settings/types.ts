/** How a setting is described, by the kind of its value. The descriptions themselves are the rows of table.ts. */

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
  /** what stands for the value in the help; left out: see kinds.ts */
  placeholder?: string;
  /** where the page has a slider or a switch for it; left out: it has a control of its own there, or none */
  page?: PageSection;
  /** It names parts of one file, so another file starts with the default. */
  isOfFile?: true;
  /** It says how one model is read or what it is for, so the page starts with the default when another one is opened. */
  isOfUse?: true;
  /** It says how a person likes results written, so the page keeps it whatever is opened. */
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
  /** the span of a slider where the whole range would be useless; logarithmic: equal steps are equal factors */
  slider?: { min: number; max: number; isLogarithmic?: true };
  default: number;
  /** 0 sets no limit. */
  isOffAtZero?: true;
}

/** One of `choices`. */
export interface ChoiceOption extends Described {
  kind: 'choice';
  choices: readonly string[];
  /** words of earlier versions, and the choice that each stands for now */
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
  /** what an empty list stands for, where that is not nothing */
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
