/** Saves the content of the stage: as a picture of any size, a video, a chart or a figure. */

import { scenarioWords } from '../../../engine/core/scenarios';
import { Choice, Section, Select, Toggle } from '../../controls/controls';
import { useHeadingFocus } from '../../controls/heading_focus';
import { NumberField } from '../../controls/number_field';
import { count } from '../../controls/numbers';
import { Spoken } from '../../controls/spoken';
import { results, shownMesh, view, wants } from '../../state/store';
import { twin } from '../../state/twin';
import { viewportHandle } from '../viewport/viewport_view';
import { deviationSvg } from './deviation_svg';
import { canDrawFigure, figurePng } from './figure';
import { SIZES, cancelPicture, makePicture, pictures } from './pictures_state';
import type { PictureJob, SizeName, VideoFormat } from './pictures_state';
import { recordTest, recordTurntable } from './recordings';
import { PIXELS, drawStage, pngOf, sizeOf } from './stage_picture';
import type { Viewport } from '../../viewer/viewport';
import './pictures.css';
import { say } from '../../language/say';

const SIZE_NAMES: Record<SizeName, string> = {
  '1x': 'As on the screen',
  '2x': 'Twice as large',
  '4k': '4K wide',
  custom: 'Custom',
};

export function PicturesPanel() {
  if (!pictures.isOpen.value || !results.body.value) return null;
  return <OpenPanel />;
}

const close = (): void => {
  pictures.isOpen.value = false;
};

function OpenPanel() {
  const heading = useHeadingFocus();
  return (
    <aside
      class="panel pictures"
      aria-labelledby="pictures-title"
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        // Escape closes the panel and does nothing else.
        event.stopPropagation();
        close();
      }}
    >
      <div class="panel-head">
        <h2 id="pictures-title" ref={heading} tabIndex={-1}>
          {say('Pictures')}
        </h2>
        <button type="button" class="quiet" aria-label={say('Close the pictures')} onClick={close}>
          {say('Close')}
        </button>
      </div>
      <Working />
      <StageSection />
      <VideoSection />
      <FigureSection />
    </aside>
  );
}

function Working() {
  const { value: work } = pictures.work;
  if (!work) return <Spoken text="" />;
  return (
    <div class="picture-work">
      <Spoken text={say(work.what)} />
      <span>
        {say(work.what)}{' '}
        <span class="muted">
          {Math.round(100 * work.share)}
          {'\u00a0'}%
        </span>
      </span>
      <button type="button" class="quiet" onClick={cancelPicture}>
        {say('Cancel')}
      </button>
      <progress max={1} value={work.share} aria-label={say(work.what)} />
    </div>
  );
}

type Making = Parameters<typeof makePicture>[0];

/** A button that makes one file at a time; it does nothing without a picture on the page. */
function MakeButton({ text, isPrimary = false, disabled = false, title, file, make }: MakeButtonProps) {
  const isWorking = pictures.work.value !== null;
  return (
    <button
      type="button"
      class={isPrimary ? 'primary' : undefined}
      title={title && say(title)}
      disabled={disabled}
      // A disabled button would lose the focus, and Escape would no longer reach the panel.
      aria-disabled={isWorking}
      onClick={() => {
        const { current } = viewportHandle;
        if (current) void makePicture(file, (job) => make(current, job));
      }}
    >
      {say(text)}
    </button>
  );
}

interface MakeButtonProps {
  text: string;
  isPrimary?: boolean;
  disabled?: boolean;
  title?: string;
  file: Making;
  make(viewport: Viewport, job: PictureJob): Promise<Uint8Array | string | null>;
}

function StageSection() {
  const { size, hasLegend, isTransparent } = pictures;
  return (
    <Section title="The stage">
      <Select
        label="Size"
        options={SIZES.map((value) => ({ value, text: SIZE_NAMES[value] }))}
        value={size.value}
        onChange={(value) => (size.value = value as SizeName)}
      />
      {size.value === 'custom' && <CustomSize />}
      <Toggle label="Legend" checked={hasLegend.value} onChange={(on) => (hasLegend.value = on)} />
      <Toggle
        label="Transparent background"
        checked={isTransparent.value}
        onChange={(on) => (isTransparent.value = on)}
      />
      <MakeButton
        text="Save PNG"
        isPrimary
        file={{ what: 'Drawing the picture', ending: 'picture.png', type: 'image/png' }}
        make={(viewport) =>
          pngOf(
            drawStage(viewport, sizeOf(size.value), {
              isTransparent: isTransparent.value,
              hasLegend: hasLegend.value,
            }),
          )
        }
      />
    </Section>
  );
}

function CustomSize() {
  const { value: custom } = pictures.custom;
  const field = (name: 'width' | 'height', label: string) => (
    <NumberField
      aria-label={label}
      min={PIXELS.least}
      max={PIXELS.most}
      value={custom[name]}
      onEnter={(value) => {
        const pixels = Math.min(PIXELS.most, Math.max(PIXELS.least, Math.round(value)));
        if (Number.isFinite(value)) pictures.custom.value = { ...custom, [name]: pixels };
      }}
    />
  );
  return (
    <div class="custom-size">
      {field('width', say('Width in pixels'))} × {field('height', say('Height in pixels'))}
      <span class="muted">{say('pixels')}</span>
    </div>
  );
}

const LONGEST_VIDEO = 60;

const VIDEO_FORMATS: { value: VideoFormat; text: string; hint: string }[] = [
  {
    value: 'webm',
    text: 'WebM',
    hint: '30 pictures a second; none is dropped, however long one takes to draw.',
  },
  {
    value: 'gif',
    text: 'GIF',
    hint: '20 pictures a second, at most 960 pixels wide or high: it plays everywhere and in a loop, but its file is larger.',
  },
];

function VideoSection() {
  const { seconds, format } = pictures;
  const { value: ending } = format;
  const isTest = view.step.value === 'test';
  const type = ending === 'gif' ? 'image/gif' : 'video/webm';
  return (
    <Section title="Video" hint={VIDEO_FORMATS.find(({ value }) => value === ending)!.hint}>
      <div class="control">
        <span>{say('Format')}</span>
        <Choice
          label="Format of the video"
          options={VIDEO_FORMATS}
          value={ending}
          onChange={(value) => (format.value = value)}
        />
      </div>
      <label class="control">
        <span>{say('Seconds')}</span>
        <NumberField
          min={0.1}
          max={LONGEST_VIDEO}
          step="any"
          value={seconds.value}
          onEnter={(value) => {
            if (Number.isFinite(value)) seconds.value = Math.min(LONGEST_VIDEO, Math.max(0.1, value));
          }}
        />
      </label>
      <div class="buttons">
        <MakeButton
          text="Save turntable"
          title="One turn around what the stage shows"
          file={{ what: 'Recording the turntable', ending: `turntable.${ending}`, type }}
          make={recordTurntable}
        />
        {isTest && (
          <MakeButton
            text="Save motion"
            title="The motion of this step from its start, at its own pace"
            disabled={twin.frame.value === null}
            file={{ what: 'Recording the motion', ending: `motion.${ending}`, type }}
            make={recordTest}
          />
        )}
      </div>
      {isTest && (
        <MakeButton
          text="Save chart as SVG"
          title="The deviation over time"
          disabled={twin.samples.value.length < 2}
          file={{ what: 'Drawing the chart', ending: 'deviation.svg', type: 'image/svg+xml' }}
          make={() => Promise.resolve(deviationSvg(twin.samples.value, chartTitle()))}
        />
      )}
    </Section>
  );
}

const chartTitle = (): string =>
  `${results.file.value!.name}, ${scenarioWords(wants.settings.value.scenario).label.toLowerCase()}: ${count((shownMesh.value?.mesh.triangles.length ?? 0) / 3)} of ${count(results.body.value!.inspection.faces)} faces`;

function FigureSection() {
  return (
    <Section
      title="Figure"
      hint="On one page: original, chosen modes, strain, result, and both in the motion of the Test step."
    >
      <MakeButton
        text="Save figure"
        disabled={!canDrawFigure()}
        title={canDrawFigure() ? undefined : 'Go to Reduce first: the figure shows the result.'}
        file={{ what: 'Simulating both for the figure', ending: 'figure.png', type: 'image/png' }}
        make={figurePng}
      />
      {!canDrawFigure() && <p class="hint">{say('Go to Reduce first: the figure shows the result.')}</p>}
    </Section>
  );
}
