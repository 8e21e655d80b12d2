/** The outputs of a file: the model with all bodies, its further levels, the binding and the report. */

import { bindingOfBody } from '../body/body_binding';
import { allFaces, layeredFaces } from '../body/layers';
import type { PreparedBody } from '../body/prepared_body';
import type { MeshAt } from '../core/core';
import { faceCount, sum } from '../core/mesh';
import { renderVertices } from '../document/export';
import type { SourceFile } from '../document/model';
import { exportFiles, furtherMesh } from '../document/write/export_files';
import type { ExportedLevels } from '../document/write/export_files';
import { outputForm } from '../document/write/output_form';
import type { OutputForm, OutputManner } from '../document/write/output_form';
import { writeBinding } from '../report/binding_file';
import { meshReport } from '../report/mesh_report';
import { calibrationReport } from '../report/motion_report';
import { startReport } from '../report/report';
import type { ReportWith } from '../report/report';
import { resultReport, worstSurface } from '../report/result_report';
import type { LevelReport } from '../report/result_report';
import { settingsFile, writeSettings } from '../report/settings_file';
import { solverReport } from '../report/solver_report';
import { stopReport, writtenFacesOf } from '../report/stop_report';
import type { StoppedBody } from '../report/stop_report';
import { methodOf } from '../settings/options';
import type { TunedBody } from '../solvers/tuned_body';
import type { BodyRun } from './body_run';
import { runSettings } from './file_request';
import type { FileRequest } from './file_request';
import type { FileRun } from './file_run';
import type { AnyStage, RunSettings, SettingsOf, ValueOf } from './stage';
import { runBodies } from './many_bodies/parallel_bodies';
import type { BodyWork } from './many_bodies/parallel_bodies';
import { STAGES } from './stages';
import { tunedResultStage } from './tuned';

/** The work for a further level, roughly, relative to that of the first level with its history. */
const WORK_OF_LEVEL = 0.2;

/** A further level of detail, not yet written anywhere. */
export interface LevelOutput {
  /** none where the level is in the file of the first */
  files: SourceFile[];
  /** the number of faces as written */
  faces: number;
  bodies: StoppedBody[];
  report: Omit<LevelReport, 'file'>;
}

/** Computes each output on first use; the runs keep the values. */
export class FileOutput {
  /** by body of the file; frozen, so that keys of them are made once */
  private readonly ofBody = new Map<number, Readonly<RunSettings>>();

  constructor(
    private readonly file: FileRun,
    private readonly request: FileRequest,
  ) {}

  /** Runs every body up to its result, without measuring it. */
  fit(): void {
    this.runBodies(STAGES.fitted);
  }

  /** Runs every body up to its measured result and calls `onDone` for each. */
  compute(onDone?: (run: BodyRun, settings: RunSettings) => void): void {
    const share = 1 / (1 + WORK_OF_LEVEL * this.levelCount);
    this.runBodies(STAGES.measured, { share, onDone: ({ run, i }) => onDone?.(run, this.runSettings(i)) });
  }

  /** The value of a stage for every body that takes part. */
  values<S extends AnyStage>(stage: S): ValueOf<S>[] {
    return this.file.usable.map(({ run, i }) => run.get(stage, this.settingsFor<S>(i)));
  }

  /** As `files`, but always a GLB. */
  async glb(): Promise<Uint8Array> {
    const [{ bytes }] = await this.write('model.glb', { format: 'glb', isZipped: false }, this.firstLevels());
    return bytes;
  }

  /**
   * The file `name`, in the format of its ending or of the settings, and those beside it, with the result of every body; bodies that do
   * not take part stay as they are. Throws an Error with one sentence where name and format contradict each other.
   */
  async files(name: string): Promise<SourceFile[]> {
    if (!this.hasLevelFiles && this.levelCount > 0) this.runBodies(STAGES.furtherLevels);
    return this.write(name, this.formOf(name), this.firstLevels());
  }

  /** Whether further levels are written to separate files. */
  get hasLevelFiles(): boolean {
    return this.request.settings.lodStyle === 'files';
  }

  get levelCount(): number {
    return this.request.settings.lods.length;
  }

  /** The further level `number`, from 0, of all bodies; `name`: of its file, where it has one of its own. */
  async level(number: number, name: string): Promise<LevelOutput> {
    this.runBodies(STAGES.furtherLevels);
    const one = (run: BodyRun, i: number): ExportedLevels => ({
      first: run.get(STAGES.writtenLevels, this.runSettings(i))[number],
      further: [],
    });
    const files = this.hasLevelFiles ? await this.write(name, this.formOf(name), one) : [];
    const levels = this.values(STAGES.furtherLevels).map((all) => all[number]);
    const histories = this.values(STAGES.history);
    const { usable } = this.file;
    const prepared = this.prepared();
    const bodies = levels.map(({ result, targetFaces, guard }, i): StoppedBody => ({
      name: usable[i].run.context.body.name,
      guard,
      ...facesOf(result, prepared[i]),
      targetFaces,
      history: histories[i],
    }));
    const report = {
      ratio: this.request.settings.lods[number],
      output: meshReport(levels.map(({ measured }) => measured)),
      surface: worstSurface(levels.map(({ measured }) => measured.distance)),
      stop: stopReport(bodies),
    };
    return { files, faces: writtenFacesOf(bodies), bodies, report };
  }

  /** The text of the binding file. */
  binding(): string {
    const [prepared, written] = [this.prepared(), this.values(STAGES.written)];
    return writeBinding(
      this.results().map((result, i) => {
        const binding = this.file.core.bindToResult(prepared[i].mesh, result);
        return bindingOfBody(prepared[i], result.mesh, written[i], binding);
      }),
    );
  }

  /** The results tuned to move like their originals in the solver of the settings; none without one. */
  tuned(): TunedBody[] {
    return this.values(STAGES.tuned).filter((tuned) => tuned !== null);
  }

  /** The text of the settings file of the first level and the further ones; there has to be a solver. */
  settings(): string {
    const { model } = this.file;
    const levels = this.file.usable.map(({ run, i }) => {
      const settings = this.runSettings(i);
      const first = { exported: run.get(STAGES.written, settings), tuned: run.get(STAGES.tuned, settings)! };
      const others = run.get(STAGES.writtenLevels, settings);
      const tuned = run.get(STAGES.tunedLevels, settings)!;
      return [first, ...others.map((exported, n) => ({ exported, tuned: tuned[n] }))];
    });
    const isInside = !this.hasLevelFiles;
    const bodies = levels[0].flatMap((_, level) =>
      levels.map((own, replaced) => ({
        name: own[level].exported.body.name,
        level,
        meshNumber:
          isInside && level > 0
            ? furtherMesh(model, { levels: own.length - 1, replaced, level })
            : own[level].exported.body.mesh,
        renderVertices: renderVertices(model, own[level].exported),
        tuned: own[level].tuned,
      })),
    );
    return writeSettings(settingsFile(bodies, this.request.settings));
  }

  prepared(): PreparedBody[] {
    return this.file.prepared(this.request.settings);
  }

  results(): MeshAt[] {
    return this.values(STAGES.fitted).map(({ result }) => result);
  }

  /** The faces, with all layers, of the bodies that take part: of the originals and of the written results. */
  writtenFaces(): { before: number; after: number } {
    const layers = this.prepared().map((prepared) => prepared.layers);
    return { before: sum(layers.map(allFaces)), after: sum(this.writtenFacesOfBodies()) };
  }

  /** The written faces, with all layers, of each body that takes part. */
  writtenFacesOfBodies(): number[] {
    const prepared = this.prepared();
    return this.results().map(({ inputOfTriangle }, i) => layeredFaces(prepared[i].layers, inputOfTriangle));
  }

  /** Why each body stopped at its number of faces. */
  stopped(): StoppedBody[] {
    const histories = this.values(STAGES.history);
    const { usable } = this.file;
    const prepared = this.prepared();
    return this.values(STAGES.fitted).map(({ result, frequency, guard }, i) => ({
      name: usable[i].run.context.body.name,
      ...facesOf(result, prepared[i]),
      targetFaces: this.request.targets[usable[i].i],
      history: histories[i],
      frequency,
      guard,
    }));
  }

  /** `options`: as used. `levels`: the further levels, with the names of their files. */
  report(options: object, levels: LevelReport[]): ReportWith<'output' | 'surface' | 'stop'> {
    const prepared = this.prepared();
    const [measured, modes] = [this.values(STAGES.measured), this.values(STAGES.guidingModes)];
    const fitted = this.values(STAGES.fitted);
    const bodies = this.stopped().map((stopped, i) => ({
      measured: measured[i],
      modes: modes[i],
      fitted: fitted[i],
      stopped,
    }));
    const { calibrate } = this.request.settings;
    const tuned = this.tuned();
    return {
      ...startReport(this.file.core, 'optimize', options, prepared),
      ...resultReport(bodies),
      ...(tuned.length > 0 ? solverReport(tuned) : {}),
      ...(calibrate ? { calibration: calibrationReport(prepared, this.values(STAGES.calibration)) } : {}),
      ...(levels.length > 0 ? { levels } : {}),
      timings: this.timings(),
    };
  }

  /** Seconds of all bodies by kind of work. */
  private timings(): Record<string, number> {
    const secondsOf = (stage: AnyStage): number =>
      sum(this.file.usable.map(({ run, i }) => run.secondsOf(stage, this.runSettings(i))));
    const isGuided = methodOf(this.request.settings).needsGuidance;
    const isSearched = this.request.settings.maxFrequencyError > 0;
    const fitted = secondsOf(STAGES.fitted);
    return {
      ...(isGuided ? { modes: secondsOf(STAGES.modes) } : {}),
      fields: secondsOf(STAGES.curvature) + (isGuided ? secondsOf(STAGES.guidance) : 0),
      simplify: secondsOf(STAGES.history),
      ...(isSearched ? { search: fitted } : {}),
      reduce: isSearched ? 0 : secondsOf(STAGES.level),
      ...(!isSearched && fitted > 0.001 ? { fit: fitted } : {}),
      measure: secondsOf(STAGES.measured),
      ...(this.request.settings.solver === 'none' ? {} : { tune: secondsOf(tunedResultStage) }),
    };
  }

  private runBodies(last: BodyWork['last'], how: Pick<BodyWork, 'share' | 'onDone'> = {}): void {
    const settingsOf = (i: number): RunSettings => this.runSettings(i);
    runBodies(this.file, this.file.usable, { ...how, settingsOf, last });
  }

  private settingsFor<S extends AnyStage>(i: number): SettingsOf<S> {
    return this.runSettings(i) as SettingsOf<S>;
  }

  private runSettings(i: number): RunSettings {
    const own = this.ofBody.get(i) ?? Object.freeze(runSettings(this.request, i));
    this.ofBody.set(i, own);
    return own;
  }

  private formOf(name: string): OutputForm {
    return outputForm(name, this.request.settings.format, this.file.model.format);
  }

  /** The result of a body, with the further levels that go into its file. */
  private firstLevels(): (run: BodyRun, i: number) => ExportedLevels {
    return (run, i) => {
      const settings = this.runSettings(i);
      const first = run.get(STAGES.written, settings);
      if (this.hasLevelFiles || this.levelCount === 0) return { first, further: [] };
      const measured = run
        .get(STAGES.furtherLevels, settings)
        .map((level) => level.measured.distance.hausdorff);
      const written = run.get(STAGES.writtenLevels, settings);
      return { first, further: written.map((exported, n) => ({ exported, deviation: measured[n] })) };
    };
  }

  private write(
    name: string,
    form: OutputForm,
    exported: (run: BodyRun, i: number) => ExportedLevels,
  ): Promise<SourceFile[]> {
    const { model, runs } = this.file;
    const { settings, fields, binding = false } = this.request;
    const manner: OutputManner = {
      compression: settings.compress,
      style: settings.lodStyle,
      keepsOrder: binding || settings.solver !== 'none',
    };
    const bodies = runs.map((run, i) => run && exported(run, i));
    return exportFiles(model, bodies, { name, form, manner, fields });
  }
}

function facesOf(
  { mesh, inputOfTriangle }: MeshAt,
  { layers }: PreparedBody,
): Pick<StoppedBody, 'faces' | 'duplicates'> {
  const faces = faceCount(mesh);
  return { faces, duplicates: layeredFaces(layers, inputOfTriangle) - faces };
}
