import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import { NONE, asked, complete, refuses, shown, type Answer } from './answers.js';
import type { Page, Question, Wording } from './description.js';
import { element, fieldElement } from './fields.js';

/** An answer as a record has it. */
export interface GivenAnswer {
  readonly page: string;
  readonly question: string;
  readonly kind: string;
  readonly value: string;
  readonly confidence?: string;
  /** Milliseconds from when the page was shown to the last change of the answer. */
  readonly ms: number;
  /** Where the question stood on its page, from 1. */
  readonly place: number;
  readonly personal?: boolean;
}

export interface QuestionnaireResult {
  readonly answers: readonly GivenAnswer[];
  /** Whether an answer refused consent; then there are no answers. */
  readonly refused: boolean;
}

const info = {
  name: 'study-questionnaire',
  version: '1.0.0',
  parameters: {
    /** The step whose questionnaire is asked. */
    step: { type: ParameterType.STRING, default: undefined },
  },
  data: { refused: { type: ParameterType.BOOL } },
} as const;

/** The plugin of jsPsych that asks a questionnaire of a study, page by page. */
export type QuestionnairePlugin = new () => JsPsychPlugin<typeof info>;

/**
 * Makes the plugin.
 *
 * @param pages gives the pages of a step
 * @param done is handed the result
 */
export function questionnairePlugin(
  pages: (step: string) => readonly Page[],
  words: Wording,
  done: (result: QuestionnaireResult) => void,
): QuestionnairePlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, trial: TrialType<typeof info>, ready?: () => void): Promise<{ refused: boolean }> {
      ready?.();
      const result = await new QuestionnaireView(display, pages(trial.step), words).result;
      display.replaceChildren();
      done(result);
      return { refused: result.refused };
    }
  };
}

/** Shows the pages of a questionnaire, one after the other and back, until all is answered. */
export class QuestionnaireView {
  readonly result: Promise<QuestionnaireResult>;

  private readonly answers = new Map<string, Answer>();
  private readonly times = new Map<string, { ms: number; place: number }>();
  private readonly form = document.createElement('form');
  private readonly note = element('p', 'fault');
  private current = 0;
  private since = 0;
  private refusing = false;
  private finish: (result: QuestionnaireResult) => void = () => undefined;

  constructor(
    private readonly display: HTMLElement,
    private readonly pages: readonly Page[],
    private readonly words: Wording,
  ) {
    this.result = new Promise((resolve) => { this.finish = resolve; });
    this.form.className = 'questionnaire';
    this.form.noValidate = true;
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.next();
    });
    this.note.setAttribute('role', 'alert');
    this.display.replaceChildren(this.form);
    this.show(0);
  }

  private get page(): Page | undefined {
    return shown(this.pages, this.answers)[this.current];
  }

  private show(index: number): void {
    this.current = index;
    this.since = performance.now();
    this.refusing = false;
    this.draw();
    window.scrollTo(0, 0);
    this.form.querySelector<HTMLElement>('h1, p, input, button')?.focus({ preventScroll: true });
  }

  private draw(): void {
    const { page } = this;
    if (!page) {
      this.complete();
      return;
    }
    const head = element('header');
    if (page.title) {
      head.append(element('h1', '', page.title));
    }
    head.append(...(page.text ?? '').split('\n').filter((text) => text !== '').map((text) => element('p', '', text)));
    if (page.picture) {
      const picture = document.createElement('img');
      picture.src = page.picture;
      picture.alt = page.title ?? '';
      head.append(picture);
    }
    const buttons = element('div', 'buttons');
    if (this.current > 0) {
      buttons.append(this.button('back', 'button', () => { this.show(this.current - 1); }));
    }
    buttons.append(this.button('next', 'submit'));
    this.note.textContent = '';
    const questions = asked(page, this.answers);
    this.form.replaceChildren(head, ...this.questions(page, questions), this.note, buttons);
  }

  private questions(page: Page, questions: readonly Question[]): HTMLElement[] {
    const drawn: HTMLElement[] = [];
    questions.forEach((question, i) => {
      if (question.stem && question.grid !== questions[i - 1]?.grid) {
        drawn.push(element('h2', '', question.stem));
      }
      drawn.push(this.question(page, question, i + 1));
    });
    return drawn;
  }

  private question(page: Page, question: Question, place: number): HTMLElement {
    const box = element('fieldset');
    box.dataset.question = question.id;
    const legend = element('legend', '', question.text ?? '');
    if (question.optional) {
      legend.append(' ', element('small', '', this.words.of('web.optional')));
    }
    box.append(legend);
    question.fields.forEach((field, i) => {
      const heading = page.headings?.[i] ?? '';
      if (heading) {
        box.append(element('p', 'heading', heading));
      }
      const answer = this.answers.get(question.id) ?? NONE;
      box.append(fieldElement(
        field,
        [question.text, heading].filter(Boolean).join(': ') || question.id,
        i === 0 ? answer.value : answer.confidence,
        this.words,
        (value) => { this.answered(page, question, i === 0 ? { value } : { confidence: value }, place); },
      ));
    });
    return box;
  }

  private answered(page: Page, question: Question, change: Partial<Answer>, place: number): void {
    const before = asked(page, this.answers).map((each) => each.id).join();
    this.answers.set(question.id, { ...NONE, ...this.answers.get(question.id), ...change });
    this.times.set(question.id, { ms: Math.round(performance.now() - this.since), place });
    this.refusing = false;
    this.note.textContent = '';
    if (asked(page, this.answers).map((each) => each.id).join() !== before) {
      this.draw(); // a question opens or closes
      this.form.querySelector<HTMLElement>(`[data-question="${CSS.escape(question.id)}"] :is(input, textarea, button)`)?.focus();
    }
  }

  private next(): void {
    const { page } = this;
    if (!page) {
      return;
    }
    const questions = asked(page, this.answers);
    const open = questions.filter((question) => !complete(question, this.answers.get(question.id) ?? NONE));
    for (const box of this.form.querySelectorAll<HTMLElement>('fieldset')) {
      box.classList.toggle('open', open.some((question) => question.id === box.dataset.question));
    }
    if (open.length > 0) {
      this.note.textContent = this.words.of('left', open.length, questions.length);
      this.form.querySelector<HTMLElement>('fieldset.open :is(input, textarea, button)')?.focus();
      return;
    }
    if (questions.some((question) => refuses(question, this.answers.get(question.id) ?? NONE))) {
      this.refuse();
      return;
    }
    this.show(this.current + 1);
  }

  private refuse(): void {
    if (this.refusing) {
      return;
    }
    this.refusing = true;
    this.note.textContent = `${this.words.of('web.form.refused')} `;
    this.note.append(this.button('form.cancel', 'button', () => { this.finish({ answers: [], refused: true }); }));
  }

  private complete(): void {
    const given = shown(this.pages, this.answers).flatMap((page) =>
      asked(page, this.answers).flatMap((question): GivenAnswer[] => {
        const answer = this.answers.get(question.id) ?? NONE;
        const time = this.times.get(question.id);
        if (answer.value === '' || !time) {
          return [];
        }
        return [{
          page: page.id,
          question: question.id,
          kind: question.kind,
          value: answer.value,
          ...(question.fields.length > 1 ? { confidence: answer.confidence } : {}),
          ...time,
          ...(question.personal ? { personal: true } : {}),
        }];
      }));
    this.finish({ answers: given, refused: false });
  }

  private button(word: string, type: 'button' | 'submit', pressed?: () => void): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = type;
    button.className = 'jspsych-btn';
    button.textContent = this.words.of(word);
    if (pressed) {
      button.addEventListener('click', pressed);
    }
    return button;
  }
}
