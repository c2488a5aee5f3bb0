import type { Slot, Step, Study, Trial } from '../description.js';

export type BlockStep = Extract<Step, { readonly kind: 'block' }>;

/** A trial at its place in a participant's order. */
export interface PlacedTrial {
  /** As in the journal of the command run: main-003, training-round2-001. */
  readonly id: string;
  /** From 1. */
  readonly number: number;
  readonly round: number;
  readonly trial: Trial;
  /** Whether the participant may rest before it. */
  readonly rest: boolean;
}

/** A participant's progress through a block: which trial comes next. */
export class BlockProgress {
  private readonly rounds: readonly (readonly PlacedTrial[])[];

  /**
   * @param done ids of the trials that are done
   * @param wrong ids of those whose response was wrong
   */
  constructor(
    private readonly step: BlockStep,
    study: Pick<Study, 'trials'>,
    slot: Pick<Slot, 'trials'>,
    block: string,
    private readonly done: Set<string>,
    private readonly wrong: Set<string>,
  ) {
    this.rounds = (slot.trials?.[block] ?? []).map((order, index) => order.map((at, i): PlacedTrial => {
      const trial = study.trials?.[at];
      if (!trial) {
        throw new Error(`study-web.json lacks a trial of the block ${block}; export the study anew`);
      }
      return { id: id(block, index + 1, i + 1), number: i + 1, round: index + 1, trial, rest: step.rest > 0 && i > 0 && i % step.rest === 0 };
    }));
  }

  /** Returns the next trial; undefined when the block is over. */
  next(): PlacedTrial | undefined {
    for (const round of this.rounds) {
      const open = round.find((trial) => !this.done.has(trial.id));
      if (open) {
        return open;
      }
      if (this.passed(round)) {
        return undefined;
      }
    }
    return undefined;
  }

  /** Takes that a trial is over. */
  add(trial: PlacedTrial, correct: boolean | undefined): void {
    this.done.add(trial.id);
    if (correct === false) {
      this.wrong.add(trial.id);
    }
  }

  /** The trials that are left of the round that comes next or is open. */
  get left(): readonly PlacedTrial[] {
    const round = this.round(this.next());
    return round.filter((trial) => !this.done.has(trial.id));
  }

  /** Whether a part of the round is over already. */
  get begun(): boolean {
    return this.left.length < this.round(this.next()).length;
  }

  private round(trial: PlacedTrial | undefined): readonly PlacedTrial[] {
    return trial ? (this.rounds[trial.round - 1] ?? []) : [];
  }

  /** Whether the block is a practice that is over without having reached its criterion. */
  get failed(): boolean {
    const shown = this.rounds.filter((round) => round.every((trial) => this.done.has(trial.id)));
    return this.step.practice !== undefined && this.next() === undefined && !this.passed(shown.at(-1) ?? []);
  }

  private passed(round: readonly PlacedTrial[]): boolean {
    const correct = round.filter((trial) => !this.wrong.has(trial.id)).length;
    return !this.step.practice || correct >= this.step.practice.correct * round.length - 1e-9;
  }
}

function id(block: string, round: number, number: number): string {
  const place = String(number).padStart(3, '0');
  return round > 1 ? `${block}-round${round}-${place}` : `${block}-${place}`;
}
