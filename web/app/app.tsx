/** The page: the layout of its panels. */

import { computed, signal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { openDropped } from './files/files';
import { ExportPanel } from './panels/export/export_panel';
import { Gallery } from './panels/motion/gallery';
import { Help } from './panels/help';
import { ModelFacts, ReadingPanel } from './panels/model/model_panel';
import { MethodsPanel } from './panels/methods/methods_panel';
import { MotionPanel } from './panels/motion/motion_panel';
import { Notices } from './panels/notices';
import { Busy } from './panels/busy';
import { QueueSection } from './panels/queue/queue_section';
import { FirstHint } from './panels/start/first_hint';
import { StartScreen } from './panels/start/start_screen';
import { PicturesPanel } from './panels/pictures/pictures_panel';
import { Readouts } from './panels/readouts';
import { ReducePanel } from './panels/reduce/reduce_panel';
import { Scrubber } from './panels/reduce/scrubber';
import { ViewportView } from './panels/viewport/viewport_view';
import { SimulateTransport } from './panels/simulate/simulate_transport';
import { SimulatePanel } from './panels/simulate/simulate_panel';
import { TopBar } from './panels/top_bar';
import { results, view, wants } from './state/store';
import { say } from './language/say';

const isDraggedOver = signal(false);

export function App() {
  return (
    <div
      class={`page step-${view.step.value}${results.file.value ? '' : ' empty-page'} sheet-${shownSheet.value}`}
      onDragOver={(event) => {
        event.preventDefault();
        // The page's own files can be dragged out; dropped back on the page, they are not opened again.
        isDraggedOver.value = event.dataTransfer?.types.includes('Files') ?? false;
      }}
      onDragLeave={(event) => {
        if (event.relatedTarget === null) isDraggedOver.value = false;
      }}
      onDrop={(event) => {
        event.preventDefault();
        isDraggedOver.value = false;
        if (event.dataTransfer?.types.includes('Files')) void openDropped(event.dataTransfer.items);
      }}
    >
      <TopBar />
      {results.file.value && (
        <aside class="panel left" aria-label={say('Model')} tabIndex={0}>
          <ModelFacts />
        </aside>
      )}
      <main>
        <ViewportView />
        <MethodsPanel />
        {!results.file.value && <StartScreen />}
        <Notices />
      </main>
      {results.file.value && <SheetHandle />}
      {results.file.value && <StepPanel />}
      <footer>
        {results.file.value && <StepFooter />}
        <div class="foot-line">
          <Readouts />
          {results.body.value && <Busy />}
        </div>
      </footer>
      <PicturesPanel />
      <Help />
      {isDraggedOver.value && <div class="drag-over">{say('Drop to open')}</div>}
    </div>
  );
}

/** On narrow windows both panels share one area; Export always comes to the front. */
const shownSheet = computed(() => (wants.exportOpen.value ? 'settings' : view.sheet.value));

function SheetHandle() {
  const choose = (sheet: 'settings' | 'facts') => {
    view.sheet.value = shownSheet.value === sheet ? 'closed' : sheet;
    if (sheet === 'facts') wants.exportOpen.value = false;
  };
  return (
    <div class="sheet-handle" role="navigation" aria-label={say('Panels')}>
      <button type="button" aria-pressed={shownSheet.value === 'settings'} onClick={() => choose('settings')}>
        {say('Settings')}
      </button>
      <button type="button" aria-pressed={shownSheet.value === 'facts'} onClick={() => choose('facts')}>
        {say('Model')}
      </button>
    </div>
  );
}

function StepPanel() {
  const panel = useRef<HTMLElement>(null);
  useLayoutEffect(() => panel.current?.scrollTo(0, 0), [view.step.value]);
  if (wants.exportOpen.value) return <ExportPanel />;
  return (
    <aside class="panel right" aria-label={say('Settings of this step')} tabIndex={0} ref={panel}>
      <QueueSection />
      <FirstHint />
      {view.step.value === 'model' && <ReadingPanel />}
      {view.step.value === 'motion' && <MotionPanel />}
      {view.step.value === 'reduce' && <ReducePanel />}
      {view.step.value === 'test' && <SimulatePanel />}
    </aside>
  );
}

function StepFooter() {
  if (view.step.value === 'motion') return <Gallery />;
  if (view.step.value === 'test') return <SimulateTransport />;
  return view.step.value === 'reduce' ? <Scrubber /> : null;
}
