import { CONDITIONS, type Condition, type ExportedScene } from '../scene/world.js';

/** A page or a question is shown only if an earlier question has one of some answers. */
export interface Rule {
  readonly question: string;
  readonly is: readonly string[];
}

export interface Option {
  readonly value: string;
  readonly label: string;
  readonly note?: string;
  readonly picture?: string;
}

/** A field is filled in: with the value, or with how sure one is of it. */
export type Field =
  | {
      readonly type: 'choice';
      readonly options: readonly Option[];
      readonly several?: boolean;
      readonly least?: string;
      readonly most?: string;
    }
  | {
      readonly type: 'line';
      readonly lines: number;
      readonly unit?: string;
      readonly range?: { readonly least: number; readonly most: number; readonly whole: boolean };
    }
  | {
      readonly type: 'slider';
      /** The values of all positions, from the left to the right. */
      readonly values: readonly string[];
      readonly least?: string;
      readonly most?: string;
      readonly number?: boolean;
      readonly marks?: boolean;
      /** The position of the thumb before it is touched, which is no answer. */
      readonly start?: number;
    }
  | { readonly type: 'ranking'; readonly options: readonly Option[] };

export interface Question {
  readonly id: string;
  readonly kind: string;
  readonly text?: string;
  readonly grid?: string;
  readonly stem?: string;
  readonly optional?: boolean;
  readonly personal?: boolean;
  readonly example?: boolean;
  /** The only value with which one may take part. */
  readonly must?: string;
  readonly sets?: string;
  readonly when?: Rule;
  readonly fields: readonly Field[];
}

export interface Page {
  readonly id: string;
  readonly title?: string;
  readonly text?: string;
  readonly picture?: string;
  readonly when?: Rule;
  readonly headings?: readonly string[];
  readonly questions: readonly Question[];
}

export interface StudyScene extends ExportedScene {
  readonly files: Readonly<Record<string, number>>;
}

export type Step =
  | { readonly kind: 'form' | 'questions' }
  | { readonly kind: 'practice'; readonly scene: string; readonly viewpoint: string }
  | {
      readonly kind: 'exposure';
      readonly scene: string;
      readonly area: string;
      readonly viewpoint: string;
      readonly seconds: number;
      readonly stay: 'turn' | 'free';
    }
  | {
      readonly kind: 'block';
      /** The number of trials after which participants may rest; 0 for never. */
      readonly rest: number;
      /** A practice is repeated until the share of correct responses is reached, at most so many rounds. */
      readonly practice?: { readonly correct: number; readonly rounds: number };
    };

/** A phase of a trial; {column} in its texts stands for a cell or a level of the trial. */
export type Phase =
  | { readonly show: 'instruction'; readonly text: string }
  | { readonly show: 'fixation'; readonly seconds: number }
  | {
      readonly show: 'exposure';
      readonly seconds?: number;
      readonly choices: Readonly<Record<string, string>>;
      readonly keys?: readonly string[];
      readonly correct?: string;
    }
  | { readonly show: 'blank'; readonly seconds?: number; readonly keys?: readonly string[]; readonly correct?: string }
  | { readonly show: 'questions'; readonly questionnaire: string }
  | {
      readonly show: 'feedback';
      readonly seconds: number;
      readonly correct: string;
      readonly wrong: string;
      readonly missing: string;
    }
  | { readonly show: 'repeat'; readonly most: number; readonly phases: readonly Phase[] };

/** A trial without its place in the order; participants share them. */
export interface Trial {
  readonly block: string;
  readonly levels: Readonly<Record<string, string>>;
  /** The line of its stimulus in the list; missing without a list. */
  readonly line?: number;
  readonly stimulus?: Readonly<Record<string, string>>;
  readonly scene: string;
  /** DEF of a Viewpoint; empty for the scene's first. */
  readonly viewpoint: string;
  readonly condition: Condition;
  /** The choices of Switches, which nothing else changes in the trial. */
  readonly choices: Readonly<Record<string, number>>;
  /** Whether the viewer's headlight is on; missing for what the scene says. */
  readonly light?: boolean;
  /** The duration of exposures that have none of their own. */
  readonly seconds?: number;
  readonly stay: 'turn' | 'free';
}

/** A participant's order, where it is not that of the file, has ids of questions by page and values of options by question. */
export interface Order {
  readonly questions?: Readonly<Record<string, readonly string[]>>;
  readonly options?: Readonly<Record<string, readonly string[]>>;
}

/** A place of the study's plan, which one participant takes. */
export interface Slot {
  readonly slot: number;
  readonly participant: string;
  readonly group: string;
  readonly condition: Condition;
  readonly seed: number;
  readonly steps: readonly string[];
  readonly order?: Readonly<Record<string, Order>>;
  /** The order of the trials of each block: indices of the study's trials, a list for each round. */
  readonly trials?: Readonly<Record<string, readonly (readonly number[])[]>>;
}

export interface Texts {
  readonly words: Readonly<Record<string, string>>;
  readonly questionnaires: Readonly<Record<string, readonly Page[]>>;
  /** The phases of the trials of each block. */
  readonly phases?: Readonly<Record<string, readonly Phase[]>>;
}

/** study-web.json says this; the command "experiment export" writes it. */
export interface Study {
  readonly name: string;
  readonly checksum: string;
  readonly languages: readonly string[];
  readonly fade: number;
  readonly mute?: boolean;
  readonly scenes: Readonly<Record<string, StudyScene>>;
  readonly steps: Readonly<Record<string, Step>>;
  readonly texts: Readonly<Record<string, Texts>>;
  /** The different trials of all blocks. */
  readonly trials?: readonly Trial[];
  readonly slots: readonly Slot[];
}

/** Checks what study-web.json holds. */
export function parse(json: unknown): Study {
  const found = json as (Partial<Study> & { format?: unknown }) | null;
  const slots = found?.slots;
  if (found?.format !== 1 || !Array.isArray(slots) || slots.length === 0
    || !slots.every((slot: Slot) => CONDITIONS.includes(slot.condition))) {
    throw new Error('study-web.json does not describe a study that this page knows; export it anew');
  }
  return found as Study;
}

/** Returns the pages of a questionnaire in a participant's order. */
export function ordered(pages: readonly Page[], order: Order | undefined): readonly Page[] {
  if (!order) {
    return pages;
  }
  return pages.map((page) => ({
    ...page,
    questions: arranged(page.questions, order.questions?.[page.id], (question) => question.id)
      .map((question) => withOptions(question, order.options?.[question.id])),
  }));
}

function withOptions(question: Question, values: readonly string[] | undefined): Question {
  const fields = question.fields.map((field, i) => (
    i === 0 && (field.type === 'choice' || field.type === 'ranking')
      ? { ...field, options: arranged(field.options, values, (option) => option.value) }
      : field
  ));
  return { ...question, fields };
}

function arranged<T>(all: readonly T[], names: readonly string[] | undefined, name: (one: T) => string): readonly T[] {
  if (!names) {
    return all;
  }
  return names.flatMap((wanted) => all.filter((one) => name(one) === wanted));
}

/** The words that participants read, with values for the places {0}, {1} in them. */
export class Wording {
  constructor(private readonly words: Readonly<Record<string, string>>) {}

  of(key: string, ...values: readonly (string | number)[]): string {
    const text = this.words[key] ?? key;
    return text.replace(/\{(\d)\}/g, (place, index: string) => String(values[Number(index)] ?? place));
  }

  /** Returns words about a number of things, which are others for a single one. */
  count(key: string, number: number, ...values: readonly (string | number)[]): string {
    const one = `${key}.one`;
    return this.of(number === 1 && one in this.words ? one : key, number, ...values);
  }

  /** Tells how far a scene is loaded; when all bytes are there, it is prepared, which may take as long. */
  loading(percent: number): string {
    return percent < 100 ? this.of('web.loading', percent) : this.of('web.measuring');
  }
}
