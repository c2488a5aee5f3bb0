import type { Page, Question, Wording } from '../description.js';
import type { QuestionnaireState } from '../questionnaire-state.js';
import type { HeadsetRoom } from './room.js';
import type { Sheet } from './sheet.js';

/** The most options that a sheet has room for. */
const MOST_OPTIONS = 24;

/** Returns whether all questions can be answered by pointing: choices and sliders, but neither texts nor orders. */
export function pointable(pages: readonly Page[]): boolean {
  return pages.every((page) => page.questions.every((question) => question.fields.every((field) =>
    field.type === 'slider' || (field.type === 'choice' && field.options.length <= MOST_OPTIONS))));
}

/** Loads the pictures of pages; one that cannot be loaded is left out, as the page does. */
export async function picturesOf(pages: readonly Page[]): Promise<Map<string, HTMLImageElement>> {
  const addresses = new Set(pages.flatMap((page) => [
    ...(page.picture === undefined ? [] : [page.picture]),
    ...page.questions.flatMap(({ fields }) => fields.flatMap((field) =>
      'options' in field ? field.options.flatMap(({ picture }) => picture ?? []) : [])),
  ]));
  const loaded = await Promise.all([...addresses].map(async (address) => {
    const picture = new Image();
    picture.src = address;
    await picture.decode().catch(() => undefined);
    return [address, picture] as const;
  }));
  return new Map(loaded.filter(([, picture]) => picture.width > 0));
}

/** Asks a questionnaire on a panel, one question after the other: the view of its state in a headset. */
export class PanelQuestionnaire {
  private place = 0;
  private note = '';
  private refusing = false;

  constructor(
    private readonly room: HeadsetRoom,
    private readonly state: QuestionnaireState,
    private readonly words: Wording,
    private readonly pictures: ReadonlyMap<string, HTMLImageElement>,
  ) {
    this.draw();
  }

  private draw(): void {
    const { page, questions } = this.state;
    if (page) {
      const question = questions[this.place];
      this.room.show((sheet) => { this.fill(sheet, page, question); }, this.pictures);
    }
  }

  private fill(sheet: Sheet, page: Page, question: Question | undefined): void {
    if (this.place === 0) {
      if (page.title) {
        sheet.title(page.title);
      }
      sheet.text(page.text ?? '');
      if (page.picture) {
        sheet.picture(page.picture);
      }
    }
    if (question) {
      if (question.stem) {
        sheet.text(question.stem);
      }
      this.question(sheet, page, question);
    }
    if (this.note) {
      sheet.note(this.note);
    }
    const buttons = [{ text: this.words.of('next'), pressed: () => { this.next(); } }];
    if (this.refusing) {
      buttons.push({ text: this.words.of('form.cancel'), pressed: () => { this.state.refuse(); } });
    }
    if (this.place > 0 || !this.state.first) {
      buttons.unshift({ text: this.words.of('back'), pressed: () => { this.back(); } });
    }
    sheet.buttons(...buttons);
  }

  private question(sheet: Sheet, page: Page, question: Question): void {
    const optional = question.optional ? ` ${this.words.of('web.optional')}` : '';
    sheet.text(`${question.text ?? ''}${optional}`, true);
    const answer = this.state.answer(question);
    question.fields.forEach((field, i) => {
      sheet.text(page.headings?.[i] ?? '');
      sheet.field(field, i === 0 ? answer.value : answer.confidence, (value) => {
        this.state.take(question, i === 0 ? { value } : { confidence: value });
        this.say('');
      });
    });
  }

  private say(note: string): void {
    this.note = note;
    this.refusing = false;
    this.draw();
  }

  private next(): void {
    const question = this.state.questions[this.place];
    if (question && this.state.open.some((each) => each.id === question.id)) {
      this.say(this.words.count('left', this.state.open.length, this.state.questions.length));
      return;
    }
    if (this.place + 1 < this.state.questions.length) {
      this.place++;
      this.say('');
      return;
    }
    switch (this.state.next()) {
      case 'page':
        this.place = 0;
        this.say('');
        break;
      case 'open':
        this.place = this.state.questions.findIndex((each) => each.id === this.state.open[0]?.id);
        this.say(this.words.count('left', this.state.open.length, this.state.questions.length));
        break;
      case 'refuses':
        this.refusing = true;
        this.note = this.words.of('form.refused');
        this.draw();
        break;
      case 'end':
        break;
    }
  }

  private back(): void {
    if (this.place > 0) {
      this.place--;
    } else {
      this.state.back();
      this.place = Math.max(0, this.state.questions.length - 1);
    }
    this.say('');
  }
}
