import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import { rising } from '../page/progress.js';
import type { Condition } from '../scene/world.js';
import type { Step, Study, Wording } from './description.js';
import { element } from './fields.js';
import { FrameRate } from './frame-rate.js';
import { preload } from './preload.js';
import type { Stage } from './stage.js';

/** A scene is measured for so long, and over so many pictures. */
const SECONDS = 1;
const PICTURES = 10;
const MOST_SECONDS = 5;

/** So many scenes are measured. */
const MOST_SCENES = 8;

/** The brightness of the picture meanwhile: participants are not to see the place yet. */
const FAINT = 0.01;

const info = {
  name: 'scene-check',
  version: '1.0.0',
  parameters: {},
  data: { frames_per_second: { type: ParameterType.FLOAT } },
} as const;

/** The plugin of jsPsych that loads the scenes and measures how fast they are drawn. */
export type SceneCheckPlugin = new () => JsPsychPlugin<typeof info>;

/**
 * Makes the plugin. A device that draws too slowly is told so and measured again, as often as the participant wants: the
 * session begins when it is fast enough.
 *
 * @param needed pictures per second
 * @param measured is handed the pictures per second of the slowest scene
 */
export function sceneCheckPlugin(
  study: Study,
  stage: Stage,
  words: Wording,
  needed: number,
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
      const say = rising((percent) => { status.textContent = words.loading(percent); });
      const views = viewsOf(study);
      await preload(filesOf(study), say);
      for (;;) {
        const rate = await slowest(views, needed, (view) => measure(view, stage, words, say, status));
        if (views.length === 0 || rate >= needed) {
          display.replaceChildren();
          measured(rate);
          return { frames_per_second: rate };
        }
        await tooSlow(display, words, rate, needed);
        status.classList.remove('over');
        display.replaceChildren(status);
      }
    }
  };
}

/** Says how fast the device is and has to be; returns when it is to be measured again. */
async function tooSlow(display: HTMLElement, words: Wording, rate: number, needed: number): Promise<void> {
  const again = document.createElement('button');
  again.type = 'button';
  again.className = 'jspsych-btn';
  again.textContent = words.of('web.slow.again');
  const told = element('p', '', words.of('web.slow', rate, needed));
  told.setAttribute('role', 'alert');
  display.replaceChildren(told, again);
  await new Promise((pressed) => { again.addEventListener('click', pressed); });
}

/** Returns whether a study shows a scene, which is then worth a check. */
export function shows(study: Study): boolean {
  return viewsOf(study).length > 0;
}

/** A scene as a step begins with it. */
interface View {
  readonly scene: string;
  readonly viewpoint: string;
  readonly condition: Condition;
  readonly choices: Readonly<Record<string, number>>;
}

function filesOf(study: Study): Record<string, number> {
  return Object.assign({}, ...Object.values(study.scenes).map(({ files }) => files)) as Record<string, number>;
}

/**
 * Returns the views that are measured, one of each scene that exposures or trials show, else that of the practice. They
 * are the same for everybody, whatever the place in the plan: in the condition high if anybody sees the scene so, else in
 * the first one that somebody sees. Who may take part must not depend on the condition.
 */
function viewsOf(study: Study): readonly View[] {
  const steps = Object.values(study.steps);
  const shown = [...steps.filter(({ kind }) => kind === 'exposure').flatMap((step) => stepView(study, step)), ...(study.trials ?? [])];
  const views = shown.length > 0 ? shown : steps.flatMap((step) => stepView(study, step)).slice(0, 1);
  const costliest = new Map<string, View>();
  for (const view of views) {
    const before = costliest.get(view.scene);
    if (!before || (before.condition !== 'high' && view.condition === 'high')) {
      costliest.set(view.scene, view);
    }
  }
  return [...costliest.values()].slice(0, MOST_SCENES);
}

/** Returns the view with which a step begins, if it shows a scene. */
function stepView(study: Study, step: Step): View[] {
  const condition = study.slots.some((slot) => slot.condition === 'high') ? 'high' : (study.slots[0]?.condition ?? 'high');
  return 'scene' in step ? [{ scene: step.scene, viewpoint: step.viewpoint, condition, choices: {} }] : [];
}

/** Measures views until one is drawn too slowly; returns the lowest rate, 0 for none. */
async function slowest(views: readonly View[], needed: number, measured: (view: View) => Promise<number>): Promise<number> {
  const rates: number[] = [];
  // The first scene comes last, so that it is open when the session begins.
  for (const view of [...views].reverse()) {
    const rate = await measured(view);
    rates.push(rate);
    if (rate < needed) {
      break;
    }
  }
  return rates.length > 0 ? Math.min(...rates) : 0;
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
