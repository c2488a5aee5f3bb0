import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import { rising } from '../page/progress.js';
import type { Condition } from '../scene/world.js';
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
      // Files that are there are opened again: participants see one progress.
      const say = rising((percent) => { status.textContent = words.of('web.loading', percent); });
      const view = viewOf(study, slot, left);
      await preload(filesOf(study, slot, left), say);
      const rate = view ? await measure(view, stage, words, say, status) : 0;
      display.replaceChildren();
      measured(rate);
      return { frames_per_second: rate };
    }
  };
}

/** Returns whether steps show a scene, which is then worth a check. */
export function shows(study: Study, slot: Slot, steps: readonly string[]): boolean {
  return viewOf(study, slot, steps) !== undefined;
}

/** A scene as a step begins with it. */
interface View {
  readonly scene: string;
  readonly viewpoint: string;
  readonly condition: Condition;
  readonly choices: Readonly<Record<string, number>>;
}

function filesOf(study: Study, slot: Slot, steps: readonly string[]): Record<string, number> {
  const files: Record<string, number> = {};
  for (const { scene } of steps.flatMap((id) => viewsOf(study, slot, id))) {
    Object.assign(files, study.scenes[scene]?.files);
  }
  return files;
}

/** Returns what a step shows, the trials of a block in their order. */
function viewsOf(study: Study, slot: Slot, id: string): View[] {
  const step = study.steps[id];
  if (step?.kind === 'block') {
    return (slot.trials?.[id] ?? []).flat().flatMap((at) => study.trials?.[at] ?? []);
  }
  return step && 'scene' in step ? [{ ...step, condition: slot.condition, choices: {} }] : [];
}

/** Returns the view that is measured: that of the first exposure or trial, else that of the practice. */
function viewOf(study: Study, slot: Slot, steps: readonly string[]): View | undefined {
  const practice = steps.filter((id) => study.steps[id]?.kind === 'practice');
  return [...steps.filter((id) => !practice.includes(id)), ...practice].flatMap((id) => viewsOf(study, slot, id))[0];
}

async function measure(
  view: View,
  stage: Stage,
  words: Wording,
  say: (percent: number) => void,
  status: HTMLElement,
): Promise<number> {
  const { world } = await stage.open(view.scene, say);
  world.setCondition(view.condition, 0);
  world.hold(view.choices);
  if (view.viewpoint) {
    world.visitNamed(view.viewpoint);
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
      world.release();
      return Math.round(10 * rate.perSecond()) / 10;
    }
  }
}
