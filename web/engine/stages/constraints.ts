/** Stages: the pinned vertices, and everything that a simplification must respect. */

import type { Document } from '@gltf-transform/core';
import { CONSTRAINT_SETTINGS, constraintsOf } from '../body/constraints';
import { findPins } from '../body/pins';
import { preparedStage } from './prepared';
import { declareStage } from './stage';
import type { RunContext } from './stage';

/** Vertices of the prepared mesh that no mode and no scenario moves, ascending. */
export const pinnedStage = declareStage({
  name: 'pinned',
  reads: ['pins'],
  needs: { prepared: preparedStage },
  run: (context, { prepared }, { pins }) => findPins(pins, documentOf(context), prepared),
});

export const constraintsStage = declareStage({
  name: 'constraints',
  reads: CONSTRAINT_SETTINGS,
  needs: { prepared: preparedStage, pinned: pinnedStage },
  run: (context, { prepared, pinned }, settings) =>
    constraintsOf(documentOf(context), prepared, pinned, settings),
});

/** The document; only settings that name an attribute use it, and a body without a document has no attributes. */
const documentOf = ({ document }: RunContext): Document => document!;
