import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import type { Answer } from './answers.js';
import type { Page, Question, Wording } from './description.js';
import { element, fieldElement } from './fields.js';
import { QuestionnaireState, type QuestionnaireResult } from './questionnaire-state.js';

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
 * @param ask asks in a headset; returns whether all was answered there
 * @param done is handed the result, and whether a headset asked
 */
export function questionnairePlugin(
  pages: (step: string) => readonly Page[],
  words: Wording,
  ask: (state: QuestionnaireState) => Promise<boolean>,
  done: (result: QuestionnaireResult, inHeadset: boolean) => void,
): QuestionnairePlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, trial: TrialType<typeof info>, ready?: () => void): Promise<{ refused: boolean }> {
      ready?.();
      const state = new QuestionnaireState(pages(trial.step));
      const inHeadset = await ask(state);
      if (!inHeadset) {
        new QuestionnaireView(display, state, words);
      }
      const result = await state.result;
      display.replaceChildren();
      done(result, inHeadset);
      return { refused: result.refused };
    }
  };
}

/** Shows the pages of a questionnaire, one after the other and back, until all is answered. */
export class QuestionnaireView {
  private readonly form = document.createElement('form');
  private readonly note = element('p', 'fault');
  private refusing = false;

  constructor(
    private readonly display: HTMLElement,
    private readonly state: QuestionnaireState,
    private readonly words: Wording,
  ) {
    this.form.className = 'questionnaire';
    this.form.noValidate = true;
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.next();
    });
    this.note.setAttribute('role', 'alert');
    this.display.replaceChildren(this.form);
    this.show();
  }

  private show(): void {
    this.refusing = false;
    this.draw();
    window.scrollTo(0, 0);
    this.form.querySelector<HTMLElement>('h1, p, input, button')?.focus({ preventScroll: true });
  }

  private draw(): void {
    const { page } = this.state;
    if (!page) {
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
    if (!this.state.first) {
      buttons.append(this.button('back', 'button', () => {
        this.state.back();
        this.show();
      }));
    }
    buttons.append(this.button('next', 'submit'));
    this.note.textContent = '';
    this.form.replaceChildren(head, ...this.questions(page, this.state.questions), this.note, buttons);
  }

  private questions(page: Page, questions: readonly Question[]): HTMLElement[] {
    const drawn: HTMLElement[] = [];
    questions.forEach((question, i) => {
      if (question.stem && question.grid !== questions[i - 1]?.grid) {
        drawn.push(element('h2', '', question.stem));
      }
      drawn.push(this.question(page, question));
    });
    return drawn;
  }

  private question(page: Page, question: Question): HTMLElement {
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
      const answer = this.state.answer(question);
      box.append(fieldElement(
        field,
        [question.text, heading].filter(Boolean).join(': ') || question.id,
        i === 0 ? answer.value : answer.confidence,
        this.words,
        (value) => { this.answered(question, i === 0 ? { value } : { confidence: value }); },
      ));
    });
    return box;
  }

  private answered(question: Question, change: Partial<Answer>): void {
    const others = this.state.take(question, change);
    this.refusing = false;
    this.note.textContent = '';
    if (others) {
      this.draw(); // a question opens or closes
      this.form.querySelector<HTMLElement>(`[data-question="${CSS.escape(question.id)}"] :is(input, textarea, button)`)?.focus();
    }
  }

  private next(): void {
    const { open, questions } = this.state;
    for (const box of this.form.querySelectorAll<HTMLElement>('fieldset')) {
      box.classList.toggle('open', open.some((question) => question.id === box.dataset.question));
    }
    switch (this.state.next()) {
      case 'open':
        this.tellOpen(open.length, questions.length);
        break;
      case 'refuses':
        this.refuse();
        break;
      case 'page':
        this.show();
        break;
      case 'end':
        break;
    }
  }

  /** Says how many questions are open, where the first of them is, and brings that into view. */
  private tellOpen(open: number, all: number): void {
    this.note.textContent = this.words.count('left', open, all);
    const first = this.form.querySelector<HTMLElement>('fieldset.open');
    first?.before(this.note);
    first?.querySelector<HTMLElement>('input, textarea, button')?.focus({ preventScroll: true });
    (first && first.offsetHeight < window.innerHeight / 2 ? first : this.note).scrollIntoView({ block: 'center' });
  }

  private refuse(): void {
    if (this.refusing) {
      return;
    }
    this.refusing = true;
    this.form.querySelector('.buttons')?.before(this.note);
    this.note.textContent = `${this.words.of('form.refused')} `;
    this.note.append(this.button('form.cancel', 'button', () => { this.state.refuse(); }));
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
