import type { Phase, Trial } from '../description.js';

/** A phase that is shown: all but a repetition, whose phases are shown. */
export type ShownPhase = Exclude<Phase, { readonly show: 'repeat' }>;

/** A phase as it was shown; times are seconds since the trial began. */
export interface PhaseTime {
  readonly phase: string;
  readonly began: number;
  readonly seconds: number;
}

/** The response of a finished trial. */
export interface TrialResponse {
  /** The key; missing without a response. */
  readonly response?: string;
  /** Milliseconds from the begin of the first phase with keys. */
  readonly ms?: number;
  /** Missing where no response is wrong. */
  readonly correct?: boolean;
}

/** A place in a list of phases, with the rounds that are left of it. */
interface Position {
  readonly phases: readonly Phase[];
  readonly repeats: boolean;
  rounds: number;
  at: number;
}

/** Returns a text in which a trial's levels and cells replace {column}. */
export function filled(trial: Pick<Trial, 'levels' | 'stimulus'>, text: string): string {
  return [...Object.entries(trial.levels), ...Object.entries(trial.stimulus ?? {})]
    .reduce((before, [name, value]) => before.replaceAll(`{${name}}`, value), text);
}

/**
 * The course of a trial through its phases, frame by frame, as the command run has it (TrialCourse.java): a phase begins
 * with the first frame that shows it and ends with the frame whose time is nearest to its planned end. The trial has one
 * response, the first: it ends the phase, or the repetition in which it falls, and later phases with keys are passed over.
 * Times are seconds of one clock.
 */
export class TrialCourse {
  /** The phases that are over. */
  readonly times: PhaseTime[] = [];

  private readonly positions: Position[];
  private current: ShownPhase | undefined;
  private begun = NaN;
  private start = NaN;
  private last = NaN;
  private asked = NaN;
  private response: string | undefined;
  private responded: number | undefined;
  private right = '';
  private goOn = false;

  /** @param began is told each phase as it begins */
  constructor(
    private readonly trial: Pick<Trial, 'levels' | 'stimulus' | 'seconds'>,
    phases: readonly Phase[],
    private readonly began: (phase: ShownPhase) => void = () => undefined,
  ) {
    this.positions = [{ phases, repeats: false, rounds: 1, at: 0 }];
  }

  /** The phase that the present frame shows; undefined before the first and after the last. */
  get phase(): ShownPhase | undefined {
    return this.current;
  }

  /** Whether the trial is over. */
  get over(): boolean {
    return !Number.isNaN(this.begun) && !this.current;
  }

  /** Begins a frame: goes on to the next phase if the present one is over. */
  frame(time: number): void {
    const interval = Number.isNaN(this.last) ? 0 : Math.max(0, time - this.last);
    this.last = time;
    if (Number.isNaN(this.begun)) {
      this.begun = time;
      this.next(time);
    }
    while (this.current && this.ended(this.current, time, interval)) {
      this.times.push({
        phase: this.current.show,
        began: round(this.start - this.begun),
        seconds: round(time - this.start),
      });
      this.next(time);
    }
  }

  private ended(phase: ShownPhase, time: number, interval: number): boolean {
    if (this.goOn) {
      return true;
    }
    // A phase of no time is passed over; any other is shown for a frame at least.
    const planned = this.planned(phase);
    return planned <= 0 || (time > this.start && time - this.start >= planned - interval / 2);
  }

  private planned(phase: ShownPhase): number {
    switch (phase.show) {
      case 'exposure':
        return phase.seconds ?? this.trial.seconds ?? Infinity;
      case 'blank':
        return phase.seconds ?? Infinity;
      case 'fixation':
      case 'feedback':
        return phase.seconds;
      default:
        return Infinity;
    }
  }

  private next(time: number): void {
    this.goOn = false;
    this.current = undefined;
    for (let position = this.positions.at(-1); position; position = this.positions.at(-1)) {
      const phase = position.phases[position.at];
      if (!phase) {
        position.rounds--;
        if (position.rounds > 0 && !this.answered) {
          position.at = 0;
        } else {
          this.positions.pop();
        }
        continue;
      }
      position.at++;
      if (phase.show === 'repeat') {
        this.positions.push({ phases: phase.phases, repeats: true, rounds: phase.most, at: 0 });
      } else if (!this.answered || keysOf(phase).length === 0) {
        this.begin(phase, time);
        return;
      }
    }
  }

  private begin(phase: ShownPhase, time: number): void {
    this.current = phase;
    this.start = time;
    if (keysOf(phase).length > 0 && Number.isNaN(this.asked)) {
      this.asked = time;
    }
    if (this.right === '' && 'keys' in phase && phase.correct) {
      this.right = filled(this.trial, phase.correct);
    }
    this.began(phase);
  }

  /** The keys that are a response now; none where there is nothing to respond to. */
  get keys(): readonly string[] {
    return this.answered || !this.current ? [] : keysOf(this.current);
  }

  private get answered(): boolean {
    return this.responded !== undefined;
  }

  /**
   * Takes a key.
   *
   * @param time when it went down
   * @returns whether it means something now
   */
  key(key: string, time: number): boolean {
    if (this.current?.show === 'instruction') {
      const on = key === 'space' || key === 'enter';
      this.goOn ||= on;
      return on;
    }
    if (!this.keys.includes(key)) {
      return false;
    }
    this.response = key;
    this.responded = Math.max(0, time - this.asked);
    this.goOn = true;
    if (this.positions.at(-1)?.repeats) {
      this.positions.pop();
    }
    return true;
  }

  /** Ends the questions that are asked. */
  questionsAnswered(): void {
    this.goOn ||= this.current?.show === 'questions';
  }

  /** Returns the text of feedback for the response, or for its lack. */
  feedback(phase: ShownPhase & { readonly show: 'feedback' }): string {
    const text = !this.answered
      ? phase.missing || phase.wrong
      : this.result().correct === false ? phase.wrong : phase.correct;
    return filled(this.trial, text);
  }

  /** Returns the response so far. */
  result(): TrialResponse {
    return {
      ...(this.responded === undefined ? {} : { response: this.response ?? '', ms: Math.round(this.responded * 10_000) / 10 }),
      ...(this.right === '' ? {} : { correct: this.response === this.right }),
    };
  }
}

function keysOf(phase: ShownPhase): readonly string[] {
  return 'keys' in phase ? (phase.keys ?? []) : [];
}

function round(seconds: number): number {
  return Math.round(seconds * 10_000) / 10_000;
}
