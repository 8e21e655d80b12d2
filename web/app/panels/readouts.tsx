/** The numbers below the viewport. */

import { faceCount } from '../../engine/core/mesh';
import type { Inspection } from '../../engine/core/core';
import { fitOf } from '../../engine/settings/options';
import { results, shownFit, shownMesh, view, wants } from '../state/store';
import type { BodySummary } from '../worker/protocol';
import { count, fixed } from '../controls/numbers';
import { Readout } from '../controls/readout';
import { Spoken } from '../controls/spoken';
import { describePart, worstPart } from './reduce/frequency_hint';
import { SimulateReadouts } from './simulate/simulate_readouts';

export function Readouts() {
  const body = results.body.value;
  if (!body) return null;
  if (view.step.value === 'test') return <SimulateReadouts />;
  const result = shownMesh.value;
  if (view.step.value !== 'reduce' || !result) return <OriginalReadouts />;
  return <ResultReadouts body={body} faces={faceCount(result.mesh)} />;
}

function ResultReadouts({ body, faces }: { body: BodySummary; faces: number }) {
  const total = faceCount(body.mesh);
  const metrics = results.metrics.value;
  const change = total > 0 ? (100 * (faces - total)) / total : 0;
  return (
    <>
      <Spoken text={spokenResult(body, faces)} />
      <dl class="readouts" tabIndex={0}>
        <Readout name="Faces" value={`${count(total)} → ${count(faces)}`} note={`${fixed(change, 1)} %`} />
        <Readout
          name="Smallest angle"
          value={metrics ? `${fixed(metrics.minAngle, 1)}°` : '...'}
          note={`was ${fixed(body.minAngle, 1)}°`}
        />
        <Readout
          name="Mean of smallest"
          value={metrics ? `${fixed(metrics.meanMinAngle, 1)}°` : '...'}
          note={`was ${fixed(body.meanMinAngle, 1)}°`}
        />
        <Readout
          name="Deviation"
          value={metrics ? `${fixed(metrics.hausdorff, 2)} %` : '...'}
          note={metrics ? `mean ${fixed(metrics.mean, 3)} %` : 'of the diagonal'}
        />
        <FrequencyReadout />
        <TopologyReadout />
      </dl>
    </>
  );
}

/** What is spoken once the result is measured; '' before that. */
function spokenResult(body: BodySummary, faces: number): string {
  const metrics = results.metrics.value;
  if (!metrics) return '';
  const shape = metrics.certificate.kept ? 'Topology kept.' : 'Topology changed.';
  return `${count(faces)} of ${count(faceCount(body.mesh))} faces, deviation ${fixed(metrics.hausdorff, 2)} %, smallest angle ${fixed(metrics.minAngle, 1)} degrees. ${shape}`;
}

function TopologyReadout() {
  const metrics = results.metrics.value;
  if (!metrics) return <Readout name="Topology" value="..." note="" />;
  const { certificate, inspection } = metrics;
  return (
    <Readout
      name="Topology"
      value={certificate.kept ? 'kept' : 'CHANGED'}
      note={describeTopology(inspection)}
      isBad={!certificate.kept}
    />
  );
}

/** The frequency errors of the part with the largest ones. There is no readout without a modal fit. */
function FrequencyReadout() {
  if (fitOf(wants.settings.value) !== 'modal') return null;
  const fitted = shownFit.value;
  if (fitted?.errorAfter.length === 0)
    return <Readout name="Frequency error" value="not fitted" note={fitted.unfitted} />;
  const at = fitted && fitted.large > 0 ? ', at half and twice the thickness' : '';
  const worst = fitted ? worstPart(fitted.errorAfter) : null;
  const where = fitted && worst ? describePart(worst.part, fitted.errorAfter.length) : '';
  const before = fitted ? Math.max(0, ...fitted.errorBefore) : 0;
  return (
    <Readout
      name="Frequency error"
      value={worst ? `${fixed(worst.error, 2)} %` : '...'}
      note={fitted ? `${where && `${where}, `}${fixed(before, 1)} % before the fit${at}` : 'fitting'}
    />
  );
}

function describeTopology({ components, boundaryLoops, genus }: Inspection): string {
  return `${count(components)} part${components === 1 ? '' : 's'}, ${boundaryLoops} border${boundaryLoops === 1 ? '' : 's'}, genus ${genus ?? 'n/a'}`;
}

function OriginalReadouts() {
  const { inspection, minAngle, meanMinAngle } = results.body.value!;
  return (
    <dl class="readouts" tabIndex={0}>
      <Readout name="Faces" value={count(inspection.faces)} note={`${count(inspection.vertices)} vertices`} />
      <Readout name="Smallest angle" value={`${fixed(minAngle, 1)}°`} note="" />
      <Readout name="Mean of smallest" value={`${fixed(meanMinAngle, 1)}°`} note="" />
      <Readout
        name="Topology"
        value={inspection.nonManifoldEdges > 0 ? 'non-manifold' : 'manifold'}
        note={describeTopology(inspection)}
      />
    </dl>
  );
}
