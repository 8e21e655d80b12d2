/** Runs one body through its stages. */

import type { CoreCall } from './many_bodies/core_call';
import { dependsOn, keyOf } from './stage';
import type { AnyStage, RunContext, RunSettings, SettingsOf, ValueOf } from './stage';

/** The last value of a stage, the key of its inputs, and the time that it took. */
interface Memo {
  key: string;
  value: unknown;
  /** without the stages that it needs */
  seconds: number;
}

export class BodyRun {
  private readonly memos = new Map<AnyStage, Memo>();
  /** seconds that were spent on the next values of stages ahead of their runs */
  private readonly secondsBefore = new Map<AnyStage, number>();

  /** `onStage` is called with the name of each stage that is about to be computed. */
  constructor(
    readonly context: RunContext,
    private readonly onStage?: (name: string) => void,
  ) {}

  /**
   * The value of a stage under these settings: the last one if nothing that it depends on has changed, otherwise
   * computed, with the stages that it needs. Throws what the stage throws; earlier values then stay. Values must not be modified.
   */
  get<S extends AnyStage>(stage: S, settings: SettingsOf<S>): ValueOf<S> {
    return this.memoOf(stage, settings as RunSettings).value as ValueOf<S>;
  }

  /** Seconds that the stage took, without the stages that it needs; 0 without a value under these settings. */
  secondsOf<S extends AnyStage>(stage: S, settings: SettingsOf<S>): number {
    return this.has(stage, settings) ? this.memos.get(stage)!.seconds : 0;
  }

  /** Whether the value of the stage under these settings has been computed. */
  has<S extends AnyStage>(stage: S, settings: SettingsOf<S>): boolean {
    return this.memos.get(stage)?.key === keyOf(stage, settings);
  }

  /**
   * The calls of the core with which the stage would begin under these settings; none if its value has been computed. Computes the stages that the
   * stage needs; throws what they throw.
   */
  firstCalls<S extends AnyStage>(stage: S, settings: SettingsOf<S>): CoreCall[] {
    const all = settings as unknown as RunSettings;
    if (!stage.isWanted(all) || this.has(stage, settings)) return [];
    const first = stage.firstCalls.bind(stage) as (
      context: RunContext,
      inputs: unknown,
      derived: unknown,
    ) => CoreCall[];
    return first(this.context, this.inputsOf(stage, all), stage.derive(all));
  }

  /** Adds seconds that were spent on the next value of the stage ahead of its run. */
  addSeconds(stage: AnyStage, seconds: number): void {
    this.secondsBefore.set(stage, (this.secondsBefore.get(stage) ?? 0) + seconds);
  }

  private memoOf(stage: AnyStage, settings: RunSettings): Memo {
    const key = keyOf(stage, settings);
    const known = this.memos.get(stage);
    if (known?.key === key) return known;
    const memo = { key, ...this.compute(stage, settings) };
    const last = this.memos.get(stage); // undefined if a stage that it needs has removed it
    this.memos.set(stage, memo);
    if (last) this.release(stage, last);
    if (last && stage.hasHandle) this.forgetDependents(stage);
    return memo;
  }

  /** Forgets the values that were made from a released handle, because they may still use it. */
  private forgetDependents(stage: AnyStage): void {
    for (const [other, memo] of [...this.memos])
      if (dependsOn(other, stage)) {
        this.memos.delete(other);
        this.release(other, memo);
      }
  }

  /** Releases the handles of all values in the core. The run must not be used afterwards. */
  dispose(): void {
    this.memos.forEach((memo, stage) => this.release(stage, memo));
    this.memos.clear();
  }

  private release(stage: AnyStage, { value }: Memo): void {
    const release = stage.release.bind(stage) as (context: RunContext, value: unknown) => void;
    if (value !== null) release(this.context, value);
  }

  private compute(stage: AnyStage, settings: RunSettings): Omit<Memo, 'key'> {
    if (!stage.isWanted(settings)) return { value: null, seconds: 0 };
    const inputs = this.inputsOf(stage, settings);
    this.onStage?.(stage.name);
    const start = performance.now();
    const run = stage.run.bind(stage) as (context: RunContext, inputs: unknown, derived: unknown) => unknown;
    const value = run(this.context, inputs, stage.derive(settings));
    const seconds = (performance.now() - start) / 1000 + (this.secondsBefore.get(stage) ?? 0);
    this.secondsBefore.delete(stage);
    return { value, seconds };
  }

  private inputsOf(stage: AnyStage, settings: RunSettings): Record<string, unknown> {
    return Object.fromEntries(
      Object.entries(stage.needs).map(([name, need]) => [name, this.memoOf(need, settings).value]),
    );
  }
}
