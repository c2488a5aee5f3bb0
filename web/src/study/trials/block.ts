import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import { ordered, type Wording } from '../description.js';
import { element } from '../fields.js';
import type { StepContext } from '../steps.js';
import { BlockProgress, type BlockStep, type PlacedTrial } from './block-progress.js';
import { TrialRun } from './trial-run.js';

const info = {
  name: 'trial-block',
  version: '1.0.0',
  parameters: {
    /** Name of the block. */
    block: { type: ParameterType.STRING, default: undefined },
  },
  data: { failed: { type: ParameterType.BOOL } },
} as const;

/** The plugin of jsPsych that runs the trials of a block, with a record of each. */
export type BlockPlugin = new () => JsPsychPlugin<typeof info>;

/** Makes the plugin. */
export function blockPlugin(context: StepContext, step: BlockStep): BlockPlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, trial: TrialType<typeof info>, ready?: () => void): Promise<{ failed: boolean }> {
      ready?.();
      const { recorder, study, slot, words } = context;
      const block = trial.block;
      const progress = new BlockProgress(step, study, slot, block, new Set(context.done), new Set(context.wrong));
      const first = progress.next();
      if (first) {
        await announce(context, display, progress, first);
      }
      for (let placed = progress.next(); placed; placed = progress.next()) {
        if (!await run(context, display, progress, placed, words)) {
          context.refused();
          return { failed: false };
        }
      }
      recorder.begin(block);
      recorder.end({ block, failed: progress.failed });
      context.ended(block);
      return { failed: progress.failed };
    }
  };
}

/** Runs a trial and records it; returns false if consent was refused in its questions. */
async function run(
  context: StepContext,
  display: HTMLElement,
  progress: BlockProgress,
  placed: PlacedTrial,
  words: Wording,
): Promise<boolean> {
  const { recorder, slot, texts, stage } = context;
  const { id, number, round, trial } = placed;
  context.begun(id);
  recorder.begin(id);
  const pages = (name: string) => ordered(texts.questionnaires[name] ?? [], slot.order?.[name]);
  const result = await new TrialRun(placed, texts, slot.seed, pages, stage, display, words).run();
  recorder.end({
    block: trial.block,
    trial: number,
    round,
    levels: trial.levels,
    ...(trial.line === undefined ? {} : { line: trial.line, stimulus: trial.stimulus }),
    ...(context.repeated === id ? { repeated: true } : {}),
    ...(result ?? { refused: true }),
  });
  if (!result) {
    return false;
  }
  progress.add(placed, result.correct);
  context.ended(id, result.correct);
  return true;
}

/** Tells what comes; the first scene is loaded meanwhile. */
async function announce(context: StepContext, display: HTMLElement, progress: BlockProgress, first: PlacedTrial): Promise<void> {
  const { words, stage } = context;
  const begin = document.createElement('button');
  begin.type = 'button';
  begin.className = 'jspsych-btn';
  begin.disabled = true;
  const lines = [words.count(progress.begun ? 'web.block.left' : 'web.block', progress.left.length)];
  if (context.repeated.startsWith(`${first.trial.block}-`)) {
    lines.unshift(words.of('web.block.again'));
  }
  display.replaceChildren(...lines.map((line) => element('p', '', line)), begin);
  await stage.open(first.trial.scene, (percent) => { begin.textContent = words.loading(percent); });
  stage.hide();
  begin.textContent = words.of('web.begin');
  begin.disabled = false;
  await new Promise((pressed) => { begin.addEventListener('click', pressed); });
  display.replaceChildren();
}
