import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import type { Walker } from '../scene/walker.js';
import type { Condition, World } from '../scene/world.js';
import type { Wording } from './description.js';
import { Fade } from './fade.js';
import { element } from './fields.js';
import { HeadLog, type Log } from './head-log.js';
import type { Stage } from './stage.js';

const info = {
  name: 'x3d-exposure',
  version: '1.0.0',
  parameters: {
    /** Name of the scene in study-web.json. */
    scene: { type: ParameterType.STRING, default: undefined },
    /** DEF of the Viewpoint; empty for where the scene begins. */
    viewpoint: { type: ParameterType.STRING, default: '' },
    /** Seconds, without the fades; 0 for a practice, which the participant ends. */
    seconds: { type: ParameterType.FLOAT, default: 0 },
    /** Seconds in which the picture comes and goes. */
    fade: { type: ParameterType.FLOAT, default: 0 },
    /** Where the viewer may go: turn, or free. */
    stay: { type: ParameterType.STRING, default: 'free' },
    /** Lines that a practice shows beside the picture. */
    hints: { type: ParameterType.STRING, array: true, default: [] },
    condition: { type: ParameterType.STRING, default: 'selective' },
    seed: { type: ParameterType.INT, default: 0 },
  },
  data: { frames: { type: ParameterType.INT } },
} as const;

type Parameters = TrialType<typeof info>;

/** The plugin of jsPsych that shows a scene for a time and logs where the participant looks. */
export type ExposurePlugin = new () => JsPsychPlugin<typeof info>;

/**
 * Makes the plugin.
 *
 * @param done is handed what was logged
 */
export function exposurePlugin(
  stage: Stage,
  words: Wording,
  done: (log: Log) => void,
): ExposurePlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, trial: Parameters, ready?: () => void): Promise<{ frames: number }> {
      const status = element('p', 'loading');
      display.replaceChildren(status);
      const { world, walker } = await stage.open(trial.scene, (percent) => {
        status.textContent = words.loading(percent);
      });
      ready?.();
      stage.darken();
      await begin(world, trial);
      display.replaceChildren();
      walker.stays = trial.stay === 'turn';
      stage.release();
      const timed = (trial.seconds ?? 0) > 0;
      const log = timed
        ? await expose(stage, world, walker, new Fade(trial.fade ?? 0, trial.seconds ?? 0))
        : await practise(stage, world, walker, display, words, trial.hints ?? []);
      stage.hide();
      display.replaceChildren();
      done(log);
      return { frames: log.rows.length };
    }
  };
}

async function begin(world: World, trial: Parameters): Promise<void> {
  world.setCondition((trial.condition ?? 'selective') as Condition, trial.seed ?? 0);
  if (trial.viewpoint) {
    world.visitNamed(trial.viewpoint);
  }
  // The areas learn of the viewer in the first frame, and the objects follow in the next.
  await world.nextFrame();
  await world.nextFrame();
}

async function expose(stage: Stage, world: World, walker: Walker, fade: Fade): Promise<Log> {
  const began = performance.now();
  const log = new HeadLog(began);
  // What holds at the beginning was told before it.
  world.entered().forEach((area) => { log.event(began, { kind: 'enter', area }); });
  world.objects.forEach((object) => { log.event(began, { kind: 'switch', object, choice: world.choice(object) }); });
  const stop = world.listen((event) => { log.event(performance.now(), event); });
  try {
    for (;;) {
      const now = performance.now();
      const t = (now - began) / 1000;
      if (fade.over(t)) {
        // The last picture was seen until now, which is long where pictures come slowly.
        log.frame(now, world.pose(), false);
        return log.log();
      }
      const brightness = fade.brightness(t);
      stage.show(brightness);
      walker.move();
      log.frame(now, world.pose(), brightness >= 0.5);
      await world.nextFrame();
    }
  } finally {
    stop();
  }
}

async function practise(
  stage: Stage, world: World, walker: Walker, display: HTMLElement, words: Wording, hints: readonly string[],
): Promise<Log> {
  const bar = element('div', 'practice');
  const button = document.createElement('button');
  button.className = 'jspsych-btn';
  button.textContent = words.of('web.practice.end');
  bar.append(...hints.map((hint) => element('p', '', hint)), button);
  display.replaceChildren(bar);
  const ended = { now: false };
  const end = (): void => { ended.now = true; };
  button.addEventListener('click', end);
  stage.squeezed = end;
  stage.show(1);
  while (!ended.now) {
    walker.move();
    await world.nextFrame();
  }
  stage.squeezed = undefined;
  return { columns: [], rows: [], events: [] };
}
