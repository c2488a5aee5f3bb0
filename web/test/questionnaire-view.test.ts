// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Wording, type Field, type Page } from '../src/study/description.js';
import { QuestionnaireView } from '../src/study/questionnaire.js';
import { QuestionnaireState } from '../src/study/questionnaire-state.js';

const YES_NO: Field = { type: 'choice', options: [{ value: 'yes', label: 'Yes' }, { value: 'no', label: 'No' }] };
const PAGE: Page = { id: 'page', questions: ['lamp', 'vase', 'rug'].map((id) => ({ id, kind: 'yes-no', text: id, fields: [YES_NO] })) };
const WORDS = new Wording({ next: 'Continue', left: '{0} of {1} questions are open.' });

/** What is scrolled into view, and where. */
let scrolled: [Element, unknown][];

beforeEach(() => {
  scrolled = [];
  vi.spyOn(HTMLElement.prototype, 'scrollIntoView').mockImplementation(function (this: HTMLElement, how) {
    scrolled.push([this, how]);
  });
});
afterEach(() => { vi.restoreAllMocks(); });

/** Shows a questionnaire whose questions have a height in pixels. */
function shown(height: number): HTMLElement {
  vi.spyOn(HTMLElement.prototype, 'offsetHeight', 'get').mockReturnValue(height);
  const display = document.createElement('div');
  document.body.replaceChildren(display);
  new QuestionnaireView(display, new QuestionnaireState([PAGE]), WORDS);
  return display;
}

function answer(display: HTMLElement, question: string): void {
  display.querySelector<HTMLInputElement>(`[data-question=${question}] input`)?.click();
}

function goOn(display: HTMLElement): void {
  display.querySelector<HTMLButtonElement>('button[type=submit]')?.click();
}

function note(display: HTMLElement): HTMLElement | null {
  return display.querySelector<HTMLElement>('[role=alert]');
}

describe('who goes on with questions open', () => {
  it('is taken to the first of them, which says how many there are', () => {
    const display = shown(100);
    answer(display, 'lamp');
    goOn(display);
    expect(note(display)?.textContent).toBe('2 of 3 questions are open.');
    const vase = display.querySelector('[data-question=vase]');
    expect(note(display)?.nextElementSibling).toBe(vase);
    expect(scrolled).toEqual([[vase, { block: 'center' }]]);
    expect(document.activeElement).toBe(vase?.querySelector('input'));
    expect([...display.querySelectorAll<HTMLElement>('fieldset.open')].map((box) => box.dataset.question)).toEqual(['vase', 'rug']);
  });

  it('sees the sentence above a question that is higher than half of the window', () => {
    const display = shown(window.innerHeight);
    goOn(display);
    expect(note(display)?.textContent).toBe('3 of 3 questions are open.');
    expect(scrolled).toEqual([[note(display), { block: 'center' }]]);
  });

  it('is taken nowhere when nothing is open', () => {
    const display = shown(100);
    ['lamp', 'vase', 'rug'].forEach((question) => { answer(display, question); });
    goOn(display);
    expect(note(display)?.textContent).toBe('');
    expect(scrolled).toEqual([]);
  });
});
