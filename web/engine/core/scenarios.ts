/**
 * The only list of scenarios in TypeScript, with their words. Each row has a row of the same name in
 * `wasm/simulate/scenario.cpp`, which defines what happens; a new scenario needs both and nothing else.
 */

interface ScenarioWords {
  name: string;
  label: string;
  /** what happens, as an aside in a help text; '' if the name says it all */
  aside: string;
  /** what happens, as a sentence; {end} stands for the upper end of the longest side, as the scene shows it */
  sentence: string;
  /** the ends of the longest side that are pinned by default; '' for none */
  pinned: 'low' | 'high' | 'both' | '';
  /** whether nothing but pins moves the body: those beyond the middle of the longest side */
  movesPins: boolean;
  /** whether the body hangs and may swing below itself, so that a view has to leave space there */
  hangs: boolean;
}

export const SCENARIOS = [
  {
    name: 'twist',
    label: 'Twist',
    aside: 'the upper end turns by 45 degrees',
    sentence: '{end} turns by 45 degrees.',
    pinned: 'both',
    movesPins: true,
    hangs: false,
  },
  {
    name: 'sway',
    label: 'Sway',
    aside: 'a sideways blow',
    sentence: '{end} is struck.',
    pinned: 'low',
    movesPins: false,
    hangs: false,
  },
  {
    name: 'hang',
    label: 'Hang',
    aside: 'gravity',
    sentence: 'Gravity pulls at the rest.',
    pinned: 'high',
    movesPins: false,
    hangs: true,
  },
  {
    name: 'drop',
    label: 'Drop',
    aside: 'onto a floor',
    sentence: 'Falls to the floor.',
    pinned: '',
    movesPins: false,
    hangs: false,
  },
  {
    name: 'pull',
    label: 'Pull',
    aside: 'the upper end moves by a fifth of the length',
    sentence: '{end} moves away by a fifth of the length.',
    pinned: 'both',
    movesPins: true,
    hangs: false,
  },
  {
    name: 'wind',
    label: 'Wind',
    aside: '',
    sentence: 'Gusts of 8 m/s, and gravity.',
    pinned: 'high',
    movesPins: false,
    hangs: true,
  },
  {
    name: 'drape',
    label: 'Drape',
    aside: 'onto a ball',
    sentence: 'Falls onto a ball.',
    pinned: '',
    movesPins: false,
    hangs: false,
  },
] as const satisfies readonly ScenarioWords[];

export type ScenarioName = (typeof SCENARIOS)[number]['name'];

export const SCENARIO_NAMES: readonly ScenarioName[] = SCENARIOS.map(({ name }) => name);

/** The words of a scenario. */
export const scenarioWords = (name: ScenarioName): ScenarioWords =>
  SCENARIOS.find((scenario) => scenario.name === name)!;

/** All scenarios with their asides as an enumeration: "twist (the ...), sway (...), ..., or drape (...)". */
export function describeScenarios(): string {
  const words = SCENARIOS.map(({ name, aside }) => (aside === '' ? name : `${name} (${aside})`));
  return `${words.slice(0, -1).join(', ')}, or ${words.at(-1)}`;
}
