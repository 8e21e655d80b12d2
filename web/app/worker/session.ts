/** One opened file and what has been computed for each of its bodies. A stage runs again when its inputs have changed. */

import type { Primitive } from '@gltf-transform/core';
import type {
  Core,
  Curvature,
  History,
  MeshAt,
  ModeSet,
  StrainGuidance,
  WhyKept,
} from '../../engine/core/core';
import { markDeviations } from '../../engine/stages/deviation_marks';
import type { DeviationMark } from '../../engine/stages/deviation_marks';
import type { OpenModel } from '../../engine/document/open';
import { methodOf } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { findHeld } from '../../engine/body/constraints';
import type { Held } from '../../engine/body/constraints';
import { findFrequencyLevel, levelAt } from '../../engine/stages/optimize';
import type { FrequencyFinding } from '../../engine/stages/frequency_target';
import { findPins } from '../../engine/body/pins';
import {
  buildHistory,
  explainResult,
  findGuidance,
  findModes,
  fitResult,
  measureDistance,
  measureResult,
  prepareBody,
  reduceTo,
} from '../../engine/stages/pipeline';
import type { FittedResult, Guides, Measured, PreparedBody } from '../../engine/stages/pipeline';
import { guidanceKey, heldKey, historyKey, modesKey, pinsKey, prepareKey, resultKey } from '../state/keys';

const isScalar = (primitive: Primitive, name: string): boolean =>
  primitive.getAttribute(name)?.getType() === 'SCALAR';

/** The last value of a stage and the inputs that it was made from. */
class Stage<T> {
  private key: string | null = null;
  private value: T | null = null;

  get(key: string, make: () => T): T {
    if (this.key !== key || this.value === null) {
      this.value = make();
      this.key = key;
    }
    return this.value;
  }
}

export interface FittedLevel extends FittedResult {
  /** null where frequencies are no target */
  frequency: FrequencyFinding | null;
}

export class BodyStages {
  private readonly preparedStage = new Stage<PreparedBody>();
  private readonly pinsStage = new Stage<Uint32Array>();
  private readonly heldStage = new Stage<{ held: Held; note: string }>();
  private readonly modesStage = new Stage<ModeSet>();
  private readonly guidanceStage = new Stage<StrainGuidance>();
  private readonly curvatureStage = new Stage<Curvature>();
  private readonly historyStage = new Stage<{ history: History; seconds: number }>();
  private readonly deviationsStage = new Stage<Map<number, number>>();
  private readonly resultStage = new Stage<MeshAt>();
  private readonly fittedStage = new Stage<FittedLevel>();
  private readonly measuredStage = new Stage<Measured>();

  constructor(
    private readonly core: Core,
    private readonly model: OpenModel,
    private readonly index: number,
  ) {}

  prepared(settings: Settings): PreparedBody {
    return this.preparedStage.get(prepareKey(settings), () =>
      prepareBody(this.core, this.model.bodies[this.index], settings, this.model.document),
    );
  }

  pinned(settings: Settings): Uint32Array {
    return this.pinsStage.get(pinsKey(settings), () =>
      findPins(settings.pins, this.model.document, this.prepared(settings)),
    );
  }

  /** What the reduction holds on to, and a sentence where a symmetry is wished that is not there. */
  held(settings: Settings): { held: Held; note: string } {
    return this.heldStage.get(heldKey(settings), () =>
      findHeld(this.model.document, this.prepared(settings), settings),
    );
  }

  modes(settings: Settings): ModeSet {
    return this.modesStage.get(modesKey(settings), () =>
      findModes(this.core, this.prepared(settings), settings, this.pinned(settings)),
    );
  }

  /** Names of the body's attributes that `attribute:NAME` can sensibly name: custom ones, colours, plain numbers. */
  pinAttributes(): string[] {
    const body = this.model.bodies[this.index];
    const primitives = this.model.document.getRoot().listMeshes()[body.mesh].listPrimitives();
    const names = body.spans.flatMap(({ primitive }) =>
      primitives[primitive]
        .listSemantics()
        .filter((name) => /^(_|COLOR_)/.test(name) || isScalar(primitives[primitive], name)),
    );
    return [...new Set(names)].sort();
  }

  guidance(settings: Settings): StrainGuidance {
    return this.guidanceStage.get(guidanceKey(settings), () =>
      findGuidance(this.core, this.prepared(settings), this.modes(settings), settings),
    );
  }

  curvature(settings: Settings): Curvature {
    return this.curvatureStage.get(prepareKey(settings), () =>
      this.core.meanCurvature(this.prepared(settings).mesh),
    );
  }

  private guides(settings: Settings): Guides {
    const guidance = methodOf(settings).needsGuidance ? this.guidance(settings) : null;
    return { guidance, curvature: this.curvature(settings), ...this.held(settings).held };
  }

  history(settings: Settings): { history: History; seconds: number } {
    return this.historyStage.get(historyKey(settings), () => {
      const prepared = this.prepared(settings);
      const guides = this.guides(settings);
      const start = performance.now();
      const history = buildHistory(this.core, prepared, guides, settings);
      return { history, seconds: (performance.now() - start) / 1000 };
    });
  }

  result(settings: Settings, faces: number): MeshAt {
    return this.resultStage.get(`${historyKey(settings)} ${faces}`, () =>
      reduceTo(this.core, this.prepared(settings), this.history(settings).history, faces),
    );
  }

  /** What keeps each vertex of the result. */
  why(settings: Settings, faces: number): WhyKept {
    return explainResult(
      this.core,
      this.prepared(settings),
      { history: this.history(settings).history, faces },
      { guides: this.guides(settings), settings },
    );
  }

  /** What has been measured stays when a call is cancelled, so that the next one goes on from there. */
  marks(settings: Settings): DeviationMark[] {
    const prepared = this.prepared(settings);
    const { history } = this.history(settings);
    const known = this.deviationsStage.get(historyKey(settings), () => new Map<number, number>());
    const deviationAt = (faces: number): number => {
      const measure = () =>
        measureDistance(this.core, prepared, reduceTo(this.core, prepared, history, faces).mesh).hausdorff;
      const deviation = known.get(faces) ?? measure();
      known.set(faces, deviation);
      return deviation;
    };
    const { triangleCount: total, trianglesAfter } = history;
    return markDeviations(deviationAt, { floor: trianglesAfter.at(-1) ?? total, total });
  }

  /** The result as it is exported: of more faces where frequencies would be off too far. */
  fitted(settings: Settings, faces: number): FittedLevel {
    return this.fittedStage.get(`${resultKey(settings)} ${faces}`, () => {
      const prepared = this.prepared(settings);
      const request = { settings, ...this.held(settings).held };
      if (settings.maxFrequencyError > 0) {
        const { history } = this.history(settings);
        const target = { ...request, targetFaces: faces };
        const { fitted, frequency } = findFrequencyLevel(this.core, prepared, history, target);
        return { ...fitted, frequency };
      }
      return { ...fitResult(this.core, prepared, this.result(settings, faces), request), frequency: null };
    });
  }

  /** A further level of detail, as the command line writes it. */
  level(settings: Settings, targetFaces: number): MeshAt {
    const request = { settings, targetFaces, ...this.held(settings).held };
    const { history } = this.history(settings);
    return levelAt(this.core, this.prepared(settings), history, request).fitted.result;
  }

  measured(settings: Settings, faces: number): Measured {
    return this.measuredStage.get(`${resultKey(settings)} ${faces}`, () =>
      measureResult(this.core, this.prepared(settings), this.fitted(settings, faces).result),
    );
  }

  /** For the report: the modes that guided, where the method has any. */
  guidingModes(settings: Settings): ModeSet | null {
    return methodOf(settings).needsGuidance ? this.modes(settings) : null;
  }
}
