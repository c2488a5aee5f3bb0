import htmlButtonResponse from '@jspsych/plugin-html-button-response';
import type { Condition } from '../scene/world.js';
import { ordered, type Slot, type Step, type Study, type Texts, type Wording } from './description.js';
import { escaped } from './escape.js';
import type { Log } from './head-log.js';
import { questionnairePlugin } from './questionnaire.js';
import { entryPlugin } from './headset/entry.js';
import type { QuestionnaireResult } from './questionnaire-state.js';
import type { Recorder } from './recorder.js';
import type { Stage } from './stage.js';
import { blockPlugin } from './trials/block.js';
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
  /** Whether the scenes are shown in a headset, if the browser knows one. */
  readonly headset: 'no' | 'offer' | 'require';
  /** The step that an earlier page left under way; empty for none. */
  readonly repeated: string;
  /** Returns what the first record tells besides. */
  readonly first: () => Readonly<Record<string, unknown>>;
  readonly begun: (step: string) => void;
  /** Steps and trials that are done, and trials among them whose response was wrong. */
  readonly done: readonly string[];
  readonly wrong: readonly string[];
  /** Is told that a step or a trial is over, and whether the response was correct. */
  readonly ended: (step: string, correct?: boolean) => void;
  readonly refused: () => void;
}

/** Makes the trials of jsPsych that are the steps of a session. */
export function timeline(context: StepContext): unknown[] {
  return context.slot.steps.filter((step) => !context.done.includes(step)).flatMap((id) => {
    const step = context.study.steps[id];
    if (!step) {
      throw new Error(`study-web.json lacks the step ${id}; export the study anew`);
    }
    if (step.kind === 'block') {
      return [{ timeline: [{ type: blockPlugin(context, step), block: id }] }];
    }
    return [{ timeline: 'scene' in step ? scene(context, id, step) : questions(context, id) }];
  });
}

function questions(context: StepContext, id: string): unknown[] {
  const { recorder, texts, slot } = context;
  const ended = (result: QuestionnaireResult, inHeadset: boolean): void => {
    if (result.refused) {
      recorder.end({ refused: true });
      context.refused();
      return;
    }
    recorder.end({ ...(id === slot.steps[0] ? context.first() : {}), ...display(inHeadset), answers: result.answers });
    context.ended(id);
  };
  return [{
    type: questionnairePlugin(
      (step) => ordered(texts.questionnaires[step] ?? [], slot.order?.[step]),
      context.words,
      (state) => context.stage.ask(state, context.words),
      ended,
    ),
    step: id,
    on_start: () => { begin(context, id); },
  }];
}

function scene(context: StepContext, id: string, step: SceneStep): unknown[] {
  const { words, slot, study } = context;
  const timed = step.kind === 'exposure';
  const again = context.repeated === id;
  const worn = { atBeginning: false };
  const ended = (log: Log): void => {
    context.recorder.end(
      timed
        ? { ...display(worn.atBeginning),  area: step.area, seconds: step.seconds, stay: step.stay, ...(again ? { repeated: true } : {}), log }
        : display(worn.atBeginning),
    );
    context.ended(id);
  };
  const later = !timed && onlyTurns(study) ? [words.of('web.practice.turn')] : [];
  const shown = {
    type: exposurePlugin(context.stage, words, ended),
    scene: step.scene,
    viewpoint: step.viewpoint,
    seconds: timed ? step.seconds : 0,
    fade: study.fade,
    stay: timed ? step.stay : 'free',
    ...(timed ? {} : { hints: [words.of('web.walk'), ...later] }),
    condition: slot.condition satisfies Condition,
    seed: slot.seed,
    on_start: () => {
      worn.atBeginning = context.stage.worn;
      begin(context, id);
    },
  };
  if (!timed && context.headset === 'no') {
    return [shown];
  }
  if (!timed) {
    return [entry(context, step.scene, [], [words.of('web.headset.walk'), ...later, words.of('web.headset.practice')]), shown];
  }
  const lines = [
    ...place(context, id),
    ...(again ? [words.of('web.again')] : []),
    words.of('web.exposure', step.seconds),
    words.of(step.stay === 'turn' ? 'web.turn' : 'web.walk'),
  ];
  if (context.headset !== 'no') {
    const inHeadset = [...lines.slice(0, -1), words.of(step.stay === 'turn' ? 'web.headset.turn' : 'web.headset.walk')];
    return [entry(context, step.scene, lines, inHeadset), shown];
  }
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

/** Returns which of several exposures comes next, which are told alike otherwise. */
function place({ study, slot, words }: StepContext, id: string): string[] {
  const exposures = slot.steps.filter((step) => study.steps[step]?.kind === 'exposure');
  return exposures.length > 1 ? [words.of('web.exposure.place', exposures.indexOf(id) + 1, exposures.length)] : [];
}

/** Returns whether there are exposures and none lets the participant walk, as the practice does. */
function onlyTurns(study: Study): boolean {
  const exposures = Object.values(study.steps).filter((step) => step.kind === 'exposure');
  return exposures.length > 0 && exposures.every((step) => step.stay === 'turn');
}

/** Tells what comes next, and lets people put the headset on. */
function entry(context: StepContext, scene: string, onScreen: readonly string[], inHeadset: readonly string[]): unknown {
  return {
    type: entryPlugin(context.stage, context.words, context.headset === 'require'),
    scene,
    on_screen: onScreen,
    in_headset: inHeadset,
  };
}

/** Returns what a record says of where a step was shown. */
function display(inHeadset: boolean): { readonly display?: string } {
  return inHeadset ? { display: 'webxr' } : {};
}

/** Loads the scene while its instruction is read; the button that shows it waits for that. */
function prepare(context: StepContext, scene: string): void {
  const button = document.querySelector<HTMLButtonElement>('#study button');
  if (!button) {
    return;
  }
  const label = button.textContent;
  button.disabled = true;
  const opened = context.stage.open(scene, (percent) => {
    button.textContent = context.words.loading(percent);
  });
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
