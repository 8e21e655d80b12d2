/** What the colours mean. */

import { spellModes } from '../../../engine/core/mode_set';
import { results, view } from '../../state/store';
import type { FieldName } from '../../state/store';
import { ColourBar } from '../../controls/colour_bar';
import { Choice, Toggle } from '../../controls/controls';
import { curvatureScale } from './curvature_scale';
import { guidingModes } from '../motion/mode_choice';
import { SimulateLegend } from '../simulate/simulate_legend';
import './legend.css';

const FIELDS: { value: FieldName; text: string; title: string }[] = [
  { value: 'none', text: 'Plain', title: 'No colours (1)' },
  { value: 'strain', text: 'Strain', title: 'Strain of the chosen modes (2)' },
  { value: 'curvature', text: 'Curvature', title: 'Mean curvature (3)' },
];

export function Legend() {
  if (!results.body.value) return null;
  if (view.step.value === 'test') return <SimulateLegend />;
  return (
    <div class="legend">
      <Choice
        label="Colour by"
        options={FIELDS}
        value={view.field.value}
        onChange={(field) => (view.field.value = field)}
      />
      <Scale />
      <Toggle label="Wireframe" checked={view.wire.value} onChange={(wire) => (view.wire.value = wire)} />
    </div>
  );
}

function Scale() {
  const curvature = results.curvature.value?.vertex;
  const { diagonal } = results.body.value!;
  if (view.field.value === 'strain')
    return <ColourBar map="viridis" title={strainTitle()} low="least" high="most" />;
  if (view.field.value === 'curvature' && curvature) {
    const high = (curvatureScale(curvature) * diagonal).toPrecision(2);
    return <ColourBar map="cividis" title="Mean curvature x diagonal" low="0" high={high} />;
  }
  return null;
}

function strainTitle(): string {
  const modes = guidingModes();
  return `Strain rank, mode${modes.length === 1 ? '' : 's'} ${spellModes(modes)}`;
}
