/** A figure as in the paper: original, chosen modes, strain, result, and both moved by the scenario of the Test step. */

import { spellModes } from '../../../engine/core/mode_set';
import type { MeshAt, TriangleMesh } from '../../../engine/core/core';
import { scenarioWords } from '../../../engine/core/scenarios';
import { count } from '../../controls/numbers';
import { endPose } from '../../state/end_pose';
import { LIGHT } from '../../state/scheme';
import { results, shownMesh, shownMetrics, shownOverview, wants } from '../../state/store';
import { drawFigure } from '../../viewer/picture/figure_pictures';
import type { FigureBody } from '../../viewer/picture/figure_pictures';
import type { Viewport } from '../../viewer/viewport';
import type { ModesResult, StrainOverview } from '../../worker/protocol';
import { guidingModes } from '../motion/mode_choice';
import { hasClearEdges } from '../viewport/show_bodies';
import { composeFigure } from './figure_page';
import type { FigurePicture } from './figure_page';
import type { PictureJob } from './pictures_state';
import { pictures } from './pictures_state';
import { pngOf } from './stage_picture';

/** Modes that are drawn, at most. */
const MAX_MODES = 3;
/** Of the diagonal: large enough to be seen in print. */
const AMPLITUDE = 0.12;
/** Of each picture, in pixels. */
const HEIGHT = 720;

/** A body of the figure with its caption. */
interface CaptionedBody extends FigureBody {
  title: string;
  detail: string;
  /** whether the strain scale is drawn below */
  hasScale: boolean;
}

/** Whether everything that the figure shows has been computed. */
export const canDrawFigure = (): boolean =>
  shownOverview.value !== null &&
  results.guidance.value !== null &&
  shownMetrics.value !== null &&
  shownMesh.value !== null;

/** PNG; null if it was cancelled. */
export async function figurePng(viewport: Viewport, job: PictureJob): Promise<Uint8Array | null> {
  const original = results.body.value!.mesh;
  const result = shownMesh.value!;
  const motion = scenarioWords(wants.settings.value.scenario).label;
  // Another body may be chosen while both are simulated.
  const atRest = [
    plain('Original', original),
    ...modeBodies(original, results.modes.value!, shownOverview.value!),
    strainBody(original),
    plain('Optimized', result.mesh),
  ];
  const pose = await endPose(job);
  if (!pose) return null;
  const moved = (mesh: TriangleMesh, positions: Float32Array): TriangleMesh => ({ ...mesh, positions });
  const bodies = [
    ...atRest,
    plain(`${motion}, original`, moved(original, pose.bodies.original.positions)),
    plain(`${motion}, optimized`, movedResult(result, pose.bodies.optimized.positions)),
  ];
  return pngOf(composeFigure(drawBodies(bodies, viewport), { isTransparent: pictures.isTransparent.value }));
}

const movedResult = ({ mesh }: MeshAt, positions: Float32Array): TriangleMesh => ({ ...mesh, positions });

const faces = ({ triangles }: TriangleMesh): number => triangles.length / 3;
const hasWires = (mesh: TriangleMesh): boolean => hasClearEdges(faces(mesh));

const plain = (title: string, mesh: TriangleMesh): CaptionedBody => ({
  ...{ mesh, field: null, hasWires: hasWires(mesh) },
  ...{ title, detail: `${count(faces(mesh))} faces`, hasScale: false },
});

/** The first chosen modes, swung, coloured by the strain of each. */
function modeBodies(mesh: TriangleMesh, modes: ModesResult, overview: StrainOverview): CaptionedBody[] {
  const { diagonal } = results.body.value!;
  const size = mesh.positions.length;
  const chosen = guidingModes().filter((number) => number <= modes.modesPerComponent);
  return chosen.slice(0, MAX_MODES).map((number) => {
    const shape = modes.shapes.subarray((number - 1) * size, number * size);
    const ranks = overview.ranks.subarray((number - 1) * faces(mesh), number * faces(mesh));
    const leading = modes.modes.find(({ ordinal }) => ordinal === number - 1);
    return {
      mesh: { ...mesh, positions: mesh.positions.map((value, i) => value + AMPLITUDE * diagonal * shape[i]) },
      field: { on: 'triangles', values: Float32Array.from(ranks, (rank) => rank / 255) },
      hasWires: false,
      title: `Mode ${number}`,
      detail: leading ? `${(leading.omega / (2 * Math.PI)).toPrecision(3)} Hz` : '',
      hasScale: false,
    };
  });
}

function strainBody(mesh: TriangleMesh): CaptionedBody {
  const chosen = guidingModes();
  return {
    mesh,
    field: { on: 'triangles', values: results.guidance.value!.rank },
    hasWires: false,
    title: 'Strain',
    detail: `mode${chosen.length === 1 ? '' : 's'} ${spellModes(chosen)}`,
    hasScale: true,
  };
}

/** From the current viewing direction of the stage. */
function drawBodies(bodies: readonly CaptionedBody[], { orbit }: Viewport): FigurePicture[] {
  const { clay, wire } = LIGHT;
  const drawn: FigurePicture[] = [];
  const eye = { orientation: orbit.camera.quaternion.clone(), height: HEIGHT, clay, wire };
  drawFigure(bodies, eye, (canvas, index) => {
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    copy.getContext('2d')?.drawImage(canvas, 0, 0);
    const { title, detail, hasScale } = bodies[index];
    drawn.push({ canvas: copy, title, detail, hasScale });
  });
  return drawn;
}
