import type { Field, Page, Question, Rule } from './description.js';

/** An answer has a value, or several of a choice with | between them, and says how sure one is. */
export interface Answer {
  readonly value: string;
  readonly confidence: string;
}

export type Answers = ReadonlyMap<string, Answer>;

export const NONE: Answer = { value: '', confidence: '' };

const SEPARATOR = '|';

/** The longest text that is taken, in characters. */
export const LONGEST = 4000;

/** Splits an answer into its values. */
export function parts(value: string): string[] {
  return value === '' ? [] : value.split(SEPARATOR);
}

/** Joins values to an answer. */
export function joined(values: readonly string[]): string {
  return values.join(SEPARATOR);
}

function holds(rule: Rule | undefined, answers: Answers): boolean {
  if (!rule) {
    return true;
  }
  const value = answers.get(rule.question)?.value ?? '';
  return rule.is.includes(value) || parts(value).some((part) => rule.is.includes(part));
}

/** Returns the questions of a page that are asked after these answers; answers to skipped ones do not count. */
export function asked(page: Page, answers: Answers): Question[] {
  const counting = new Map(answers);
  return page.questions.filter((question) => {
    const open = holds(question.when, counting);
    if (!open) {
      counting.delete(question.id);
    }
    return open;
  });
}

/** Returns the pages that are shown after these answers. */
export function shown(pages: readonly Page[], answers: Answers): Page[] {
  const counting = new Map(answers);
  return pages.filter((page) => {
    const open = holds(page.when, counting);
    const questions = open ? asked(page, counting) : [];
    page.questions.filter((question) => !questions.includes(question)).forEach((question) => counting.delete(question.id));
    return open;
  });
}

/** Returns whether an answer is whole; an optional question needs none. */
export function complete(question: Question, answer: Answer): boolean {
  const whole = answer.value !== '' && (question.fields.length < 2 || answer.confidence !== '');
  return whole || (question.optional === true && answer.value === '' && answer.confidence === '');
}

/** Returns whether an answer refuses consent. */
export function refuses(question: Question, answer: Answer): boolean {
  return question.must !== undefined && answer.value !== '' && answer.value !== question.must;
}

/** Returns the value of what was typed; undefined if it is not a valid answer. */
export function typed(field: Field & { type: 'line' }, text: string): string | undefined {
  const stripped = text.trim();
  if (!field.range) {
    return stripped.length <= LONGEST ? stripped : undefined;
  }
  const number = stripped.replace(',', '.'); // German and Greek keyboards have a decimal comma
  if (!/^[+-]?\d{1,12}(\.\d{1,9})?$/.test(number)) {
    return undefined;
  }
  const value = Number(number);
  const { least, most, whole } = field.range;
  return value >= least && value <= most && (!whole || Number.isInteger(value)) ? String(value) : undefined;
}
