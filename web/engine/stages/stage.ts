/**
 * A stage is one step of a run over a body. It declares which settings it reads and which stages it needs; memo keys follow
 * from these declarations, so that a result is never stale and never computed twice.
 */

import type { Document } from '@gltf-transform/core';
import type { Core } from '../core/core';
import type { Body } from '../document/model';
import type { Settings } from '../settings/options';
import type { CoreCall } from './many_bodies/core_call';
import type { ValueCache } from './many_bodies/value_cache';

/** Everything that can change between two runs over the same body. */
export interface RunSettings extends Settings {
  /** the most faces that the result may have; where the history ends above it, the result has more */
  targetFaces: number;
  /** the fewest faces that any level of the body is asked for, so that its history may end there; absent: it goes down to its floor */
  fewestFaces?: number;
  /** the same for each further level; absent: their share of the body's own faces */
  levelFaces?: number[];
  /** whether the written body has strain and curvature as attributes */
  fields: boolean;
}

export type RunSettingName = keyof RunSettings;

/** What is the same in every run over one body. */
export interface RunContext {
  core: Core;
  body: Body;
  /** where the body comes from; null: it has no attributes, and none can be named */
  document: Document | null;
  /** how many bodies the file has whose results are asked for, where modes are needed for guidance alone; absent: for their own sake */
  guidedBodies?: number;
  /** the cache that the bodies of a file share; absent: there is one body */
  cache?: ValueCache;
  /** whether the body is so small in its scene that its modes do not matter, see `scene_share`; absent: it is not */
  isTooSmallToMove?: boolean;
  /** whether the body has so few faces of its file that a search for a few per cent less is not worth its time; absent: it has not */
  hasFewFaces?: boolean;
  /** called before each number of faces that is tried to keep the frequencies */
  onTry?: (faces: number) => void;
}

/** A stage of any type. */
export interface AnyStage {
  readonly name: string;
  /** the settings that it reads, itself or through the stages that it needs */
  readonly reads: readonly RunSettingName[];
  readonly needs: Readonly<Record<string, AnyStage>>;
  /** what `run` receives of the settings that the stage reads; memos compare it by value */
  derive(settings: RunSettings): unknown;
  /** if false, the value is null and no stage that it needs is run */
  isWanted(settings: RunSettings): boolean;
  run(context: RunContext, inputs: never, derived: never): unknown;
  /** the calls of the core with which `run` begins, through `resultOf`; all of one function */
  firstCalls(context: RunContext, inputs: never, derived: never): CoreCall[];
  /** whether values own a handle in the core: values made from one are invalid once it has been released */
  readonly hasHandle: boolean;
  /** releases the handle of a value in the core, once another value has replaced it */
  release(context: RunContext, value: never): void;
}

export type Needs = AnyStage['needs'];

/** Whether a stage needs another one, itself or through those that it needs. */
export const dependsOn = (stage: AnyStage, other: AnyStage): boolean =>
  Object.values(stage.needs).some((need) => need === other || dependsOn(need, other));

export interface Stage<Value, Read extends RunSettingName> extends AnyStage {
  readonly reads: readonly Read[];
  run(context: RunContext, inputs: never, derived: never): Value;
}

export type ValueOf<S extends AnyStage> = S extends {
  run(context: RunContext, inputs: never, derived: never): infer Value;
}
  ? Value
  : never;

/** The settings without which a stage cannot run. */
export type SettingsOf<S extends AnyStage> = Pick<RunSettings, S['reads'][number]>;

/** The settings that the stages of `N` read. */
type ReadBy<N extends Needs> = N[keyof N]['reads'][number];

interface StageDeclaration<Value, Read extends RunSettingName, N extends Needs, Derived> {
  name: string;
  /** the settings that the stage itself reads */
  reads: readonly Read[];
  needs: N;
  /**
   * Reduces the settings that are read to their effect: settings without effect under the others are left out or resolved. Absent:
   * all of them are taken unchanged. The result is plain data.
   */
  derive?: (settings: Pick<RunSettings, Read>) => Derived;
  run: (
    context: RunContext,
    inputs: { [Key in keyof N]: ValueOf<N[Key]> },
    derived: NoInfer<Derived>,
  ) => Value;
  firstCalls?: (
    context: RunContext,
    inputs: { [Key in keyof N]: ValueOf<N[Key]> },
    derived: NoInfer<Derived>,
  ) => CoreCall[];
  release?: (context: RunContext, value: NoInfer<Value>) => void;
}

/** A stage whose `run` can see no setting but those in `reads`: neither by its types nor at run time. */
export function declareStage<
  Value,
  Read extends RunSettingName,
  N extends Needs,
  Derived = Pick<RunSettings, Read>,
>(declaration: StageDeclaration<Value, Read, N, Derived>): Stage<Value, Read | ReadBy<N>> {
  const { name, reads: own, needs, run, firstCalls = () => [], release = () => {} } = declaration;
  const derive = declaration.derive ?? ((settings) => settings as Derived);
  const reads = withNeeds(own, needs);
  return {
    name,
    reads,
    needs,
    derive: (all) => derive(pick(all, own)),
    isWanted: () => true,
    run,
    firstCalls,
    hasHandle: declaration.release !== undefined,
    release,
  };
}

/** A stage that has the value of `stage` where `isWanted`; elsewhere it is null and `stage` is not run. `own`: what `isWanted` reads. */
export function where<S extends AnyStage, Read extends RunSettingName>(
  stage: S,
  own: readonly Read[],
  isWanted: (settings: Pick<RunSettings, Read>) => boolean,
): Stage<ValueOf<S> | null, Read | S['reads'][number]> {
  const needs = { stage };
  return {
    name: `${stage.name} where wanted`,
    reads: withNeeds(own, needs),
    needs,
    derive: () => null,
    isWanted: (all) => isWanted(pick(all, own)),
    run: (_context, inputs: { stage: ValueOf<S> }) => inputs.stage,
    firstCalls: () => [],
    hasHandle: false,
    release: () => {},
  };
}

function withNeeds<Read extends RunSettingName, N extends Needs>(
  own: readonly Read[],
  needs: N,
): (Read | ReadBy<N>)[] {
  return [...new Set<RunSettingName>([...own, ...Object.values(needs).flatMap(({ reads }) => reads)])] as (
    Read | ReadBy<N>
  )[];
}

function pick<Read extends RunSettingName>(
  settings: RunSettings,
  names: readonly Read[],
): Pick<RunSettings, Read> {
  return Object.fromEntries(names.map((name) => [name, settings[name]])) as Pick<RunSettings, Read>;
}

const knownKeys = new WeakMap<RunSettings, Map<AnyStage, string>>();

/**
 * A key that is equal for two settings if the stage has the same value for both: what it derives from them, and what every
 * stage that it needs derives. It is cached for frozen settings.
 */
export function keyOf<S extends AnyStage>(stage: S, settings: SettingsOf<S>): string {
  const all = settings as RunSettings;
  const known = knownKeys.get(all) ?? new Map<AnyStage, string>();
  const found = known.get(stage);
  if (found !== undefined) return found;
  const key = wholeKey(stage, all);
  if (Object.isFrozen(all)) knownKeys.set(all, known.set(stage, key));
  return key;
}

function wholeKey(stage: AnyStage, settings: RunSettings): string {
  const seen = new Set<AnyStage>();
  const parts: string[] = [];
  const add = (one: AnyStage): void => {
    if (seen.has(one)) return;
    seen.add(one);
    parts.push(partOf(one, settings));
    if (one.isWanted(settings)) Object.values(one.needs).forEach(add);
  };
  add(stage);
  return parts.join('\n');
}

const knownParts = new WeakMap<RunSettings, Map<AnyStage, string>>();

/** What a stage itself derives, as text; cached for frozen settings. */
function partOf(stage: AnyStage, settings: RunSettings): string {
  const known = knownParts.get(settings) ?? new Map<AnyStage, string>();
  const found = known.get(stage);
  if (found !== undefined) return found;
  const part = stage.isWanted(settings)
    ? `${stage.name} ${JSON.stringify(stage.derive(settings), spellNumber)}`
    : `no ${stage.name}`;
  if (Object.isFrozen(settings)) knownParts.set(settings, known.set(stage, part));
  return part;
}

/** JSON has no infinity. */
const spellNumber = (_key: string, value: unknown): unknown =>
  typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;
