import type { Walker } from '../../scene/walker.js';
import type { World } from '../../scene/world.js';
import type { Page, Phase, Texts, Wording } from '../description.js';
import { element } from '../fields.js';
import { HeadLog, type Log } from '../head-log.js';
import { QuestionnaireView } from '../questionnaire.js';
import { QuestionnaireState, type GivenAnswer } from '../questionnaire-state.js';
import type { Stage } from '../stage.js';
import type { PlacedTrial } from './block-progress.js';
import { keyName } from './key-name.js';
import { filled, TrialCourse, type PhaseTime, type ShownPhase, type TrialResponse } from './trial-course.js';

/** What came of a trial. */
export interface TrialResult extends TrialResponse {
  readonly phases: readonly PhaseTime[];
  readonly answers: readonly GivenAnswer[];
  readonly log: Log;
}

/**
 * Runs a trial. What begins with a frame is on the screen one frame later, with the choices of its Switches drawn: all
 * that is shown is late by the same frame, so that durations are right and nothing of before is seen.
 */
export class TrialRun {
  private readonly overlay = element('div', 'trial');
  private readonly course: TrialCourse;
  private readonly answers: GivenAnswer[] = [];
  private readonly buttons = matchMedia('(pointer: coarse)').matches;
  private drawn: ShownPhase | undefined;
  private world: World | undefined;
  private refused = false;

  /**
   * @param seed of the participant, for objects that are drawn at random
   * @param pages gives the pages of a questionnaire
   */
  constructor(
    private readonly placed: PlacedTrial,
    texts: Texts,
    private readonly seed: number,
    private readonly pages: (questionnaire: string) => readonly Page[],
    private readonly stage: Stage,
    private readonly display: HTMLElement,
    private readonly words: Wording,
  ) {
    const phases: readonly Phase[] = texts.phases?.[placed.trial.block] ?? [];
    this.course = new TrialCourse(
      placed.trial,
      placed.rest ? [{ show: 'instruction', text: words.of('trial.rest') }, ...phases] : phases,
      (phase) => { this.began(phase); },
    );
    this.overlay.setAttribute('role', 'status');
  }

  /** Returns what came of the trial; undefined if consent was refused in its questions. */
  async run(): Promise<TrialResult | undefined> {
    const listening = new AbortController();
    try {
      return await this.shown(listening.signal);
    } finally {
      listening.abort();
      this.world?.release();
      this.stage.hide();
      this.display.replaceChildren();
    }
  }

  private async shown(signal: AbortSignal): Promise<TrialResult | undefined> {
    const { world, walker } = await this.open();
    await this.prepare(world, walker);
    window.addEventListener('keydown', (event) => { this.key(event); }, { capture: true, signal });
    this.display.replaceChildren(this.overlay);
    const began = performance.now();
    const log = new HeadLog(began);
    world.entered().forEach((area) => { log.event(began, { kind: 'enter', area }); });
    const choices = Object.fromEntries(world.objects.map((object) => [object, world.choice(object)]));
    Object.entries({ ...choices, ...this.placed.trial.choices })
      .forEach(([object, choice]) => { log.event(began, { kind: 'switch', object, choice }); });
    const stop = world.listen((event) => { log.event(performance.now(), event); });
    try {
      while (!this.course.over) {
        const now = performance.now();
        const exposing = this.course.phase?.show === 'exposure';
        this.draw(this.course.phase);
        this.course.frame(now / 1000);
        if (exposing) {
          walker.move();
        }
        if (this.course.phase?.show === 'questions') {
          await this.ask(this.course.phase.questionnaire);
          if (this.refused) {
            return undefined;
          }
          log.pause(performance.now());
        } else if (this.course.phase?.show === 'instruction') {
          log.pause(now); // as long as the participant reads
        } else {
          log.frame(now, world.pose(), exposing);
        }
        await world.nextFrame();
      }
    } finally {
      stop();
    }
    return { ...this.course.result(), phases: this.course.times, answers: this.answers, log: log.log() };
  }

  private async open(): Promise<{ world: World; walker: Walker }> {
    const opened = await this.stage.open(this.placed.trial.scene, (percent) => {
      this.overlay.textContent = this.words.loading(percent);
    });
    this.world = opened.world;
    return opened;
  }

  private async prepare(world: World, walker: Walker): Promise<void> {
    const { trial, number } = this.placed;
    this.stage.release();
    this.stage.show(0);
    world.setCondition(trial.condition, this.seed + number);
    if (trial.viewpoint) {
      world.visitNamed(trial.viewpoint);
    } else {
      world.visit(0);
    }
    world.headlight(trial.light);
    world.hold(trial.choices);
    walker.stays = trial.stay === 'turn';
    // The areas learn of the viewer in the first frame, and the objects follow in the next.
    await world.nextFrame();
    await world.nextFrame();
  }

  /** Sets the choices of an exposure that begins; they are drawn with the next frame. */
  private began(phase: ShownPhase): void {
    if (phase.show === 'exposure') {
      const { trial } = this.placed;
      this.world?.hold(Object.fromEntries(Object.entries(phase.choices).map(([name, choice]) => [
        filled(trial, name),
        choiceOf(filled(trial, choice), filled(trial, name)),
      ])));
    }
  }

  private draw(phase: ShownPhase | undefined): void {
    if (phase === this.drawn) {
      return;
    }
    this.drawn = phase;
    this.stage.show(phase?.show === 'exposure' ? 1 : 0);
    this.overlay.replaceChildren(...this.parts(phase));
    if (this.buttons && this.course.keys.length > 0) {
      const keys = element('div', 'keys');
      keys.append(...this.course.keys.map((key) => this.button(key, key)));
      this.overlay.append(keys);
    }
  }

  private parts(phase: ShownPhase | undefined): HTMLElement[] {
    switch (phase?.show) {
      case 'instruction':
        return [
          ...filled(this.placed.trial, phase.text).split('\n').map((line) => element('p', '', line)),
          ...(this.buttons ? [] : [element('p', 'hint', this.words.of('trial.read'))]),
          this.button(this.words.of('next'), 'space'),
        ];
      case 'fixation':
        return [element('p', 'cross', '+')];
      case 'feedback':
        return [element('p', 'feedback', this.course.feedback(phase))];
      default:
        return [];
    }
  }

  private button(text: string, key: string): HTMLElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'jspsych-btn';
    button.textContent = text;
    button.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      this.course.key(key, event.timeStamp / 1000);
    });
    // Programs and assistive technology press without a pointer.
    button.addEventListener('click', (event) => { this.course.key(key, event.timeStamp / 1000); });
    return button;
  }

  private key(event: KeyboardEvent): void {
    const modified = event.ctrlKey || event.metaKey || event.altKey;
    // A key that is held since the trial before is no response.
    if (!event.repeat && !modified && this.course.key(keyName(event), event.timeStamp / 1000)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  /** Asks in place of the picture. */
  private async ask(questionnaire: string): Promise<void> {
    this.drawn = this.course.phase;
    this.stage.hide();
    const state = new QuestionnaireState(this.pages(questionnaire));
    new QuestionnaireView(this.display, state, this.words);
    const { answers, refused } = await state.result;
    if (refused) {
      this.refused = true;
      return;
    }
    this.answers.push(...answers);
    this.course.questionsAnswered();
    await this.open();
    this.overlay.replaceChildren();
    this.display.replaceChildren(this.overlay);
    this.stage.show(0);
  }
}

/** Returns the choice that a text says. */
function choiceOf(text: string, name: string): number {
  if (!/^(-1|\d{1,6})$/.test(text)) {
    throw new Error(`'${text}' is no choice of the Switch ${name}; the study's list of stimuli is wrong`);
  }
  return Number(text);
}
