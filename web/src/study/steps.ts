import htmlButtonResponse from '@jspsych/plugin-html-button-response';
import type { Condition } from '../scene/world.js';
import { ordered, type Slot, type Step, type Study, type Texts, type Wording } from './description.js';
import { escaped } from './escape.js';
import type { Log } from './head-log.js';
import { questionnairePlugin } from './questionnaire.js';
import type { QuestionnaireResult } from './questionnaire-state.js';
import type { Recorder } from './recorder.js';
import type { Stage } from './stage.js';
import { exposurePlugin } from './x3d-exposure.js';

type SceneStep = Extract<Step, { readonly scene: string }>;

/** A step needs this to be shown and recorded. */
export interface StepContext {
  readonly study: Study;
  readonly slot: Slot;
  readonly texts: Texts;
  readonly words: Wording;
  readonly stage: Stage;
  readonly recorder: Recorder;
  /** The step that an earlier page left under way; empty for none. */
  readonly repeated: string;
  /** Returns what the first record tells besides. */
  readonly first: () => Readonly<Record<string, unknown>>;
  readonly begun: (step: string) => void;
  readonly ended: (step: string) => void;
  readonly refused: () => void;
}

/** Makes the trials of jsPsych that are the steps of a session. */
export function timeline(context: StepContext, done: readonly string[]): unknown[] {
  return context.slot.steps.filter((step) => !done.includes(step)).flatMap((id) => {
    const step = context.study.steps[id];
    if (!step) {
      throw new Error(`study-web.json lacks the step ${id}; export the study anew`);
    }
    return [{ timeline: 'scene' in step ? scene(context, id, step) : questions(context, id) }];
  });
}

function questions(context: StepContext, id: string): unknown[] {
  const { recorder, texts, slot } = context;
  const ended = (result: QuestionnaireResult): void => {
    if (result.refused) {
      recorder.end({ refused: true });
      context.refused();
      return;
    }
    recorder.end({ ...(id === slot.steps[0] ? context.first() : {}), answers: result.answers });
    context.ended(id);
  };
  return [{
    type: questionnairePlugin((step) => ordered(texts.questionnaires[step] ?? [], slot.order?.[step]), context.words, ended),
    step: id,
    on_start: () => { begin(context, id); },
  }];
}

function scene(context: StepContext, id: string, step: SceneStep): unknown[] {
  const { words, slot, study } = context;
  const timed = step.kind === 'exposure';
  const again = context.repeated === id;
  const ended = (log: Log): void => {
    context.recorder.end(
      timed
        ? { area: step.area, seconds: step.seconds, stay: step.stay, ...(again ? { repeated: true } : {}), log }
        : {},
    );
    context.ended(id);
  };
  const shown = {
    type: exposurePlugin(context.stage, words, ended),
    scene: step.scene,
    viewpoint: step.viewpoint,
    seconds: timed ? step.seconds : 0,
    fade: study.fade,
    stay: timed ? step.stay : 'free',
    condition: slot.condition satisfies Condition,
    seed: slot.seed,
    on_start: () => { begin(context, id); },
  };
  if (!timed) {
    return [shown];
  }
  const lines = [
    ...(again ? [words.of('web.again')] : []),
    words.of('web.exposure', step.seconds),
    words.of(step.stay === 'turn' ? 'web.turn' : 'web.walk'),
  ];
  return [
    {
      type: htmlButtonResponse,
      stimulus: lines.map((line) => `<p>${escaped(line)}</p>`).join(''),
      choices: [escaped(words.of('web.begin'))],
      on_load: () => { prepare(context, step.scene); },
    },
    shown,
  ];
}

/** Loads the scene while its instruction is read; the button that shows it waits for that. */
function prepare(context: StepContext, scene: string): void {
  const button = document.querySelector<HTMLButtonElement>('#study button');
  if (!button) {
    return;
  }
  const label = button.textContent;
  button.disabled = true;
  const opened = context.stage.open(scene, context.words, (text) => { button.textContent = text; });
  void opened.then(() => {
    context.stage.hide();
    button.textContent = label;
    button.disabled = false;
  });
}

function begin(context: StepContext, id: string): void {
  context.begun(id);
  context.recorder.begin(id);
}
