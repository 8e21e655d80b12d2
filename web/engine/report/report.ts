/**
 * The JSON report that every command gives. Lengths in % of the bounding-box diagonal, angles in degrees, times in
 * seconds, errors in %, MAC in 0..1. A key that a command does not produce is absent.
 *
 * With several bodies, counts are sums, angles are the smallest and the mean over all faces, components are numbered across
 * bodies, modes are sorted together, and distances and fidelity are those of the worst body.
 */

import type { InspectedBody } from '../body/prepared_body';
import type { Core, Model, SurfaceDistance } from '../core/core';
import { VERSION } from '../core/version';
import { methodOf, readsSetting, resolveModel, resolveModes, settingsOf } from '../settings/options';
import type { Command, SettingName, Settings } from '../settings/options';
import { meshReport } from './mesh_report';
import type { MeshReport } from './mesh_report';
import type { ComponentReport, ModeReport, SolveReport, ZeroModes } from './modes_report';
import type { CalibrationReport, SimulationReport } from './motion_report';
import type { FitReport, LevelReport } from './result_report';
import type { FidelityReport } from './solver_report';
import type { StopReport } from './stop_report';

export interface Report {
  /** 2 where there is `fidelity.solvers` */
  schema: 'limber-report/1' | 'limber-report/2';
  version: string;
  command: string;
  /** the options as used: `auto` is resolved; p may be "inf" */
  options: Record<string, unknown>;
  threads: number;
  /** size of the wasm memory */
  peakHeapBytes: number;
  input: MeshReport;
  output?: MeshReport;
  model?: Model | 'mixed';
  components?: ComponentReport[];
  zeroModes?: ZeroModes;
  /** elastic modes, by ascending frequency */
  modes?: ModeReport[];
  solve?: SolveReport;
  fit?: FitReport;
  surface?: SurfaceDistance;
  fidelity?: FidelityReport;
  simulation?: SimulationReport;
  calibration?: CalibrationReport[];
  stop?: StopReport;
  levels?: LevelReport[];
  timings: Record<string, number>;
}

/** A report in which these parts are present. */
export type ReportWith<Part extends keyof Report> = Report & Required<Pick<Report, Part>>;

/** The keys that every report has. */
export function startReport(core: Core, command: string, options: object, bodies: InspectedBody[]): Report {
  return {
    schema: 'limber-report/1',
    version: VERSION,
    command,
    options: Object.fromEntries(Object.entries(options).map(([key, value]) => [key, spellInfinity(value)])),
    threads: core.threads,
    peakHeapBytes: core.peakHeapBytes(),
    input: meshReport(bodies),
    timings: {},
  };
}

/** JSON has no infinity. */
const spellInfinity = (value: unknown): unknown => (value === Infinity ? 'inf' : value);

/** The settings that a command takes; texts that are empty are left out. */
export function settingsOfCommand(command: Command, settings: Settings): Partial<Settings> {
  const used = settingsOf(command).filter((setting: SettingName) => settings[setting] !== '');
  return Object.fromEntries(used.map((setting) => [setting, settings[setting]]));
}

/** The settings of an optimization that its method reads; `auto` is resolved, unless the method follows no modes. */
export function settingsOfMethod(settings: Settings): object {
  const read = Object.entries(settings).filter(([name]) => readsSetting(settings, name as SettingName));
  const used = Object.fromEntries(read);
  if (!methodOf(settings).needsGuidance) return used;
  return { ...used, model: resolveModel(settings), modes: resolveModes(settings) };
}
