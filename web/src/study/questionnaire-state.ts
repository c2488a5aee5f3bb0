import { NONE, asked, complete, refuses, shown, type Answer } from './answers.js';
import type { Page, Question } from './description.js';

/** An answer as a record has it. */
export interface GivenAnswer {
  readonly page: string;
  readonly question: string;
  readonly kind: string;
  readonly value: string;
  readonly confidence?: string;
  /** Milliseconds from when the page was shown to the last change of the answer. */
  readonly ms: number;
  /** Where the question stood on its page after the last answer, from 1. */
  readonly place: number;
  readonly personal?: boolean;
}

export interface QuestionnaireResult {
  readonly answers: readonly GivenAnswer[];
  /** Whether an answer refused consent; then there are no answers. */
  readonly refused: boolean;
}

/** What came of going on from a page: the next one, questions that are open, a refusal to confirm, or the end. */
export type Going = 'page' | 'open' | 'refuses' | 'end';

/** The answers to a questionnaire so far, and the page that is asked; the page and the headset's panel are its views. */
export class QuestionnaireState {
  readonly result: Promise<QuestionnaireResult>;

  private readonly answers = new Map<string, Answer>();
  private readonly times = new Map<string, number>();
  private current = 0;
  private since = performance.now();
  private finish: (result: QuestionnaireResult) => void = () => undefined;

  constructor(readonly pages: readonly Page[]) {
    this.result = new Promise((resolve) => { this.finish = resolve; });
    if (!this.page) {
      this.complete();
    }
  }

  /** Returns the page that is asked; undefined at the end. */
  get page(): Page | undefined {
    return shown(this.pages, this.answers)[this.current];
  }

  /** Whether the page is the first one. */
  get first(): boolean {
    return this.current === 0;
  }

  /** Returns the questions of the page that are asked after the answers so far. */
  get questions(): readonly Question[] {
    return this.page ? asked(this.page, this.answers) : [];
  }

  /** Returns the questions of the page whose answers are not whole. */
  get open(): readonly Question[] {
    return this.questions.filter((question) => !complete(question, this.answer(question)));
  }

  answer(question: Question): Answer {
    return this.answers.get(question.id) ?? NONE;
  }

  /** Takes an answer; returns whether other questions are asked than before. */
  take(question: Question, change: Partial<Answer>): boolean {
    const before = this.questions.map((each) => each.id).join();
    this.answers.set(question.id, { ...this.answer(question), ...change });
    this.times.set(question.id, Math.round(performance.now() - this.since));
    return this.questions.map((each) => each.id).join() !== before;
  }

  /** Goes on, if all is answered. */
  next(): Going {
    if (this.open.length > 0) {
      return 'open';
    }
    if (this.questions.some((question) => refuses(question, this.answer(question)))) {
      return 'refuses';
    }
    this.turn(this.current + 1);
    if (this.page) {
      return 'page';
    }
    this.complete();
    return 'end';
  }

  /** Goes one page back. */
  back(): void {
    this.turn(Math.max(0, this.current - 1));
  }

  /** Ends with the consent refused. */
  refuse(): void {
    this.finish({ answers: [], refused: true });
  }

  private turn(page: number): void {
    this.current = page;
    this.since = performance.now();
  }

  private complete(): void {
    const given = shown(this.pages, this.answers).flatMap((page) =>
      asked(page, this.answers).flatMap((question, at): GivenAnswer[] => {
        const answer = this.answer(question);
        const ms = this.times.get(question.id);
        if (answer.value === '' || ms === undefined) {
          return [];
        }
        return [{
          page: page.id,
          question: question.id,
          kind: question.kind,
          value: answer.value,
          ...(question.fields.length > 1 ? { confidence: answer.confidence } : {}),
          ms,
          place: at + 1,
          ...(question.personal ? { personal: true } : {}),
        }];
      }));
    this.finish({ answers: given, refused: false });
  }
}
