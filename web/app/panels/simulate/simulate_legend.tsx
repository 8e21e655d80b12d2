/** The legend of the moving bodies' colours. */

import { isWireShown } from '../viewport/show_bodies';
import { twin } from '../../state/twin';
import { view } from '../../state/store';
import { Choice, Toggle } from '../../controls/controls';
import { ColourBar } from '../../controls/colour_bar';
import { heatScale } from './simulate_scale';

const COLOURS = [
  { value: 'plain', text: 'Plain', title: 'No colours (C)' },
  {
    value: 'deviation',
    text: 'Deviation',
    title: 'How far each point of the original is from the optimized mesh (C)',
  },
] as const;

export function SimulateLegend() {
  const isHeat = twin.heat.value;
  return (
    <div class={isHeat ? 'legend' : 'legend short'}>
      <Choice
        label="Colour by"
        options={COLOURS}
        value={isHeat ? 'deviation' : 'plain'}
        onChange={(colour) => (twin.heat.value = colour === 'deviation')}
      />
      {isHeat && (
        <ColourBar map="viridis" title="Deviation, % of diagonal" low="0" high={String(heatScale.value)} />
      )}
      <Toggle label="Wireframe" checked={isWireShown()} onChange={(wire) => (view.wire.value = wire)} />
    </div>
  );
}
