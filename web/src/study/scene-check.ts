import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import type { Slot, Study, Wording } from './description.js';
import { element } from './fields.js';
import { FrameRate } from './frame-rate.js';
import { preload } from './preload.js';
import type { Stage } from './stage.js';

/** The scene is measured for so long, and over so many pictures. */
const SECONDS = 1;
const PICTURES = 10;
const MOST_SECONDS = 5;

/** The brightness of the picture meanwhile: participants are not to see the place yet. */
const FAINT = 0.01;

const info = {
  name: 'scene-check',
  version: '1.0.0',
  parameters: {},
  data: { frames_per_second: { type: ParameterType.FLOAT } },
} as const;

/** The plugin of jsPsych that loads the scenes and measures how fast the first one of an exposure is drawn. */
export type SceneCheckPlugin = new () => JsPsychPlugin<typeof info>;

/**
 * Makes the plugin.
 *
 * @param left the steps that are still to come
 * @param measured is handed the pictures per second
 */
export function sceneCheckPlugin(
  study: Study,
  slot: Slot,
  left: readonly string[],
  stage: Stage,
  words: Wording,
  measured: (rate: number) => void,
): SceneCheckPlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, _trial: TrialType<typeof info>, ready?: () => void): Promise<{ frames_per_second: number }> {
      ready?.();
      const status = element('p', 'loading');
      status.setAttribute('role', 'status');
      display.replaceChildren(status);
      await preload(filesOf(study, left), (percent) => { status.textContent = words.of('web.loading', percent); });
      const rate = await measure(study, slot, left, stage, words, status);
      display.replaceChildren();
      measured(rate);
      return { frames_per_second: rate };
    }
  };
}

/** Returns whether steps show a scene, which is then worth a check. */
export function shows(study: Study, steps: readonly string[]): boolean {
  return steps.some((id) => study.steps[id]?.kind === 'exposure' || study.steps[id]?.kind === 'practice');
}

function filesOf(study: Study, steps: readonly string[]): Record<string, number> {
  const files: Record<string, number> = {};
  for (const id of steps) {
    const step = study.steps[id];
    if (step && 'scene' in step) {
      Object.assign(files, study.scenes[step.scene]?.files);
    }
  }
  return files;
}

async function measure(
  study: Study,
  slot: Slot,
  left: readonly string[],
  stage: Stage,
  words: Wording,
  status: HTMLElement,
): Promise<number> {
  const steps = left.flatMap((id) => study.steps[id] ?? []);
  const step = steps.find((each) => each.kind === 'exposure') ?? steps.find((each) => each.kind === 'practice');
  if (!step || !('scene' in step)) {
    return 0;
  }
  const { world } = await stage.open(step.scene, words, (text) => { status.textContent = text; });
  world.setCondition(slot.condition, slot.seed);
  if (step.viewpoint) {
    world.visitNamed(step.viewpoint);
  }
  status.classList.add('over');
  status.textContent = words.of('web.measuring');
  const rate = new FrameRate(SECONDS, PICTURES, MOST_SECONDS);
  // A picture that is not shown at all would not be drawn, and would not be measured.
  stage.show(FAINT);
  for (;;) {
    await world.nextFrame();
    if (rate.picture(performance.now())) {
      stage.hide();
      return Math.round(10 * rate.perSecond()) / 10;
    }
  }
}
