import { describe, expect, it } from 'vitest';
import { LONGEST, asked, complete, joined, parts, refuses, shown, typed, type Answer } from '../src/study/answers.js';
import type { Field, Page, Question } from '../src/study/description.js';

const YES_NO: Field = { type: 'choice', options: [{ value: 'yes', label: 'Yes' }, { value: 'no', label: 'No' }] };

function question(id: string, more: Partial<Question> = {}): Question {
  return { id, kind: 'yes-no', fields: [YES_NO], ...more };
}

function answers(given: Readonly<Record<string, string>>): Map<string, Answer> {
  return new Map(Object.entries(given).map(([id, value]) => [id, { value, confidence: '' }]));
}

const PAGES: Page[] = [
  {
    id: 'first',
    questions: [
      question('noticed'),
      question('what', { when: { question: 'noticed', is: ['yes'] } }),
      question('sure', { when: { question: 'what', is: ['yes'] } }),
    ],
  },
  { id: 'second', when: { question: 'sure', is: ['yes'] }, questions: [question('end')] },
];

function idsAfter(given: Readonly<Record<string, string>>): string[] {
  const [page] = PAGES;
  return page ? asked(page, answers(given)).map((each) => each.id) : [];
}

describe('what is asked', () => {
  it('depends on earlier answers', () => {
    expect(idsAfter({})).toEqual(['noticed']);
    expect(idsAfter({ noticed: 'yes' })).toEqual(['noticed', 'what']);
  });

  it('does not depend on an answer to a question that is closed again', () => {
    expect(idsAfter({ noticed: 'no', what: 'yes' })).toEqual(['noticed']);
    expect(shown(PAGES, answers({ noticed: 'no', what: 'yes', sure: 'yes' })).map((page) => page.id)).toEqual(['first']);
    expect(shown(PAGES, answers({ noticed: 'yes', what: 'yes', sure: 'yes' })).map((page) => page.id)).toEqual(['first', 'second']);
  });

  it('opens by one of several answers of a choice', () => {
    expect(idsAfter({ noticed: joined(['other', 'yes']) })).toContain('what');
  });
});

describe('an answer', () => {
  it('is whole with its confidence, if that is asked; an optional one may be left out as a whole', () => {
    const sure = question('lamp', { fields: [YES_NO, YES_NO] });
    expect(complete(sure, { value: 'yes', confidence: '' })).toBe(false);
    expect(complete(sure, { value: 'yes', confidence: '3' })).toBe(true);
    expect(complete({ ...sure, optional: true }, { value: '', confidence: '' })).toBe(true);
    expect(complete({ ...sure, optional: true }, { value: '', confidence: '3' })).toBe(false);
  });

  it('refuses consent if it is another than the needed one', () => {
    const consent = question('consent', { must: 'yes' });
    expect(['yes', 'no', ''].map((value) => refuses(consent, { value, confidence: '' }))).toEqual([false, true, false]);
    expect(refuses(question('other'), { value: 'no', confidence: '' })).toBe(false);
  });

  it('joins several values, and none', () => {
    expect(parts(joined(['a', 'b']))).toEqual(['a', 'b']);
    expect(parts(joined([]))).toEqual([]);
  });
});

describe('what is typed', () => {
  const age: Field & { type: 'line' } = { type: 'line', lines: 1, range: { least: 18, most: 99, whole: true } };
  const weight: Field & { type: 'line' } = { type: 'line', lines: 1, range: { least: -1, most: 200, whole: false } };

  it.each([['18', '18'], [' 30 ', '30'], ['030', '30'], ['17', undefined], ['30.5', undefined], ['1e1', undefined], ['', undefined]])(
    'is a number in its range: %s',
    (text, value) => { expect(typed(age, text)).toBe(value); },
  );

  it('has a decimal point or comma', () => {
    expect([typed(weight, '70.5'), typed(weight, '70,5'), typed(weight, '-0,5')]).toEqual(['70.5', '70.5', '-0.5']);
  });

  it('is a text that is not endless', () => {
    const text: Field & { type: 'line' } = { type: 'line', lines: 3 };
    expect(typed(text, '  a lamp\n')).toBe('a lamp');
    expect(typed(text, 'x'.repeat(LONGEST + 1))).toBeUndefined();
  });
});
