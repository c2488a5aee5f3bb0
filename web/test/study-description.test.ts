import { readFileSync } from 'node:fs';
import path from 'node:path';
import { describe, expect, it } from 'vitest';
import { Wording, ordered, parse } from '../src/study/description.js';

/** The description that the command writes, as its own test has it. */
const GOLDEN = path.resolve(
  import.meta.dirname,
  '../../modules/export/src/test/resources/org/selectiverenderer/export/study/study-web.json',
);

describe('study-web.json', () => {
  it('is read as the command writes it', () => {
    const study = parse(JSON.parse(readFileSync(GOLDEN, 'utf8')));
    expect(study.slots.map((slot) => slot.condition)).toEqual(['high', 'selective', 'high', 'selective']);
    const [first] = study.slots;
    expect(first?.steps.every((step) => study.steps[step] !== undefined)).toBe(true);
    const pages = ordered(study.texts.el?.questionnaires['recognition-desk'] ?? [], first?.order?.['recognition-desk']);
    expect(pages[0]?.questions.map((question) => question.text)).toEqual(['βραστήρας', 'λάμπα', 'στυλό']);
  });

  it.each([null, {}, { format: 2, slots: [{}] }, { format: 1, slots: [] }, { format: 1, slots: [{ condition: 'best' }] }])(
    'is refused as %j',
    (json) => { expect(() => parse(json)).toThrow('export it anew'); },
  );
});

describe('the order of a participant', () => {
  const options = [{ value: 'a', label: 'A' }, { value: 'b', label: 'B' }];
  const pages = [{
    id: 'page',
    questions: [
      { id: 'one', kind: 'single', fields: [{ type: 'choice' as const, options }] },
      { id: 'two', kind: 'single', fields: [{ type: 'choice' as const, options }] },
    ],
  }];

  it('is that of the file where nothing else is said', () => {
    expect(ordered(pages, undefined)).toBe(pages);
  });

  it('arranges questions and options', () => {
    const [page] = ordered(pages, { questions: { page: ['two', 'one'] }, options: { one: ['b', 'a'] } });
    expect(page?.questions.map((question) => question.id)).toEqual(['two', 'one']);
    expect(page?.questions.map((question) => question.fields.flatMap((field) => ('options' in field ? field.options : []))
      .map((option) => option.value).join(''))).toEqual(['ab', 'ba']);
  });
});

describe('words', () => {
  it('have values for the places in them, and stand for themselves where they are missing', () => {
    const words = new Wording({ left: '{0} of {1} {2}' });
    expect(words.of('left', 3, 'five')).toBe('3 of five {2}');
    expect(words.of('missing')).toBe('missing');
  });
});

describe('the words of participants', () => {
  const words = new Wording({
    left: '{0} of {1} are left.', 'left.one': '1 is left.', more: '{0} more', 'web.loading': '{0} %', 'web.measuring': 'It is prepared.',
  });

  it('are others for a single thing, where there are such words', () => {
    expect([words.count('left', 2, 3), words.count('left', 1, 3), words.count('more', 1)]).toEqual(['2 of 3 are left.', '1 is left.', '1 more']);
  });

  it('say of a scene whose bytes are there that it is prepared', () => {
    expect([words.loading(99), words.loading(100)]).toEqual(['99 %', 'It is prepared.']);
  });
});
