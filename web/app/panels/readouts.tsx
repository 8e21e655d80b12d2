/** The numbers below the viewport. */

import { faceCount } from '../../engine/core/mesh';
import type { Inspection } from '../../engine/core/core';
import { fitOf } from '../../engine/settings/options';
import { results, shownFit, shownMesh, shownMetrics, view, wants } from '../state/store';
import type { BodySummary } from '../worker/protocol';
import { count, fixed } from '../controls/numbers';
import { Readout } from '../controls/readout';
import { Spoken } from '../controls/spoken';
import { describePart, worstPart } from './reduce/frequency_hint';
import { SimulateReadouts } from './simulate/simulate_readouts';
import { say, sayCounted, sentence } from '../language/say';

export function Readouts() {
  const body = results.body.value;
  if (!body) return null;
  if (view.step.value === 'test') return <SimulateReadouts />;
  const result = shownMesh.value;
  if (view.step.value !== 'reduce' || !result) return <OriginalReadouts />;
  return <ResultReadouts body={body} faces={faceCount(result.mesh)} />;
}

/** The mesh of a scene that the numbers describe. */
function NameReadout() {
  const { bodies } = results.file.value!;
  const chosen = wants.body.value;
  if (bodies.length === 1) return null;
  const which = say('{number} of {all}', { number: count(chosen + 1), all: count(bodies.length) });
  return <Readout name="Mesh" value={bodies[chosen].name} note={which} width="named" phoneOrder={0} />;
}

function ResultReadouts({ body, faces }: { body: BodySummary; faces: number }) {
  const total = faceCount(body.mesh);
  const metrics = shownMetrics.value;
  const change = total > 0 ? (100 * (faces - total)) / total : 0;
  return (
    <>
      <Spoken text={spokenResult(body, faces)} />
      <dl class="readouts" tabIndex={0}>
        <NameReadout />
        <Readout
          name="Faces"
          value={`${count(total)} → ${count(faces)}`}
          note={`${fixed(change, 1)} %`}
          width="wider"
          phoneOrder={1}
        />
        <Readout
          name="Smallest angle"
          value={metrics ? `${fixed(metrics.minAngle, 1)}°` : '...'}
          note={say('was {angle}°', { angle: fixed(body.minAngle, 1) })}
        />
        <Readout
          name="Mean of smallest"
          value={metrics ? `${fixed(metrics.meanMinAngle, 1)}°` : '...'}
          note={say('was {angle}°', { angle: fixed(body.meanMinAngle, 1) })}
        />
        <Readout
          name="Deviation"
          value={metrics ? `${fixed(metrics.hausdorff, 2)} %` : '...'}
          note={metrics ? say('mean {mean} %', { mean: fixed(metrics.mean, 3) }) : say('of the diagonal')}
          width="wide"
          phoneOrder={3}
        />
        <FrequencyReadout />
        <TopologyReadout />
      </dl>
    </>
  );
}

/** The text for screen readers once the result is measured; '' before that. */
function spokenResult(body: BodySummary, faces: number): string {
  const metrics = shownMetrics.value;
  if (!metrics) return '';
  const shape = metrics.certificate.kept ? say('Topology kept.') : say('Topology changed.');
  return say('{faces} of {all} faces, deviation {deviation} %, smallest angle {angle} degrees. {topology}', {
    faces: count(faces),
    all: count(faceCount(body.mesh)),
    deviation: fixed(metrics.hausdorff, 2),
    angle: fixed(metrics.minAngle, 1),
    topology: shape,
  });
}

function TopologyReadout() {
  const metrics = shownMetrics.value;
  if (!metrics) return <Readout name="Topology" value="..." note="" width="widest" phoneOrder={2} />;
  const { certificate, inspection } = metrics;
  return (
    <Readout
      name="Topology"
      value={certificate.kept ? say('kept') : say('CHANGED')}
      note={describeTopology(inspection)}
      isBad={!certificate.kept}
      width="widest"
      phoneOrder={2}
    />
  );
}

/** The frequency errors of the part with the largest ones. There is no readout without a modal fit. */
function FrequencyReadout() {
  if (fitOf(wants.settings.value) !== 'modal') return null;
  const fitted = shownFit.value;
  if (fitted?.errorAfter.length === 0)
    return (
      <Readout
        name="Frequency error"
        value={say('not fitted')}
        note={sentence(fitted.unfitted)}
        width="widest"
      />
    );
  const at = fitted && fitted.large > 0 ? say(', at half and twice the thickness') : '';
  const worst = fitted ? worstPart(fitted.errorAfter) : null;
  const where = fitted && worst ? describePart(worst.part, fitted.errorAfter.length) : '';
  const before = fitted ? Math.max(0, ...fitted.errorBefore) : 0;
  return (
    <Readout
      name="Frequency error"
      value={worst ? `${fixed(worst.error, 2)} %` : '...'}
      note={
        fitted
          ? `${where && `${where}, `}${say('{error} % before the fit', { error: fixed(before, 1) })}${at}`
          : say('fitting')
      }
      width="widest"
    />
  );
}

function describeTopology({ components, boundaryLoops, genus }: Inspection): string {
  return [
    sayCounted(components, '{count} part', '{count} parts'),
    sayCounted(boundaryLoops, '{count} border', '{count} borders'),
    ...(genus === null ? [] : [sayCounted(genus, '{count} handle', '{count} handles')]),
  ].join(', ');
}

function OriginalReadouts() {
  const { inspection, minAngle, meanMinAngle } = results.body.value!;
  return (
    <dl class="readouts" tabIndex={0}>
      <NameReadout />
      <Readout
        name="Faces"
        value={count(inspection.faces)}
        note={sayCounted(inspection.vertices, '{count} vertex', '{count} vertices')}
        width="wider"
        phoneOrder={1}
      />
      <Readout name="Smallest angle" value={`${fixed(minAngle, 1)}°`} note="" />
      <Readout name="Mean of smallest" value={`${fixed(meanMinAngle, 1)}°`} note="" />
      <Readout
        name="Topology"
        value={inspection.nonManifoldEdges > 0 ? say('non-manifold') : say('manifold')}
        note={describeTopology(inspection)}
        width="widest"
        phoneOrder={2}
      />
    </dl>
  );
}
