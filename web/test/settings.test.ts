import { describe, expect, it } from 'vitest';
import { askedSlot, completion, language, recruitment, settings } from '../src/study/settings.js';

describe('study-settings.json', () => {
  it('has its usual values for what is missing', () => {
    expect(settings({ minWidth: 800 })).toEqual({
      receiver: '',
      completion: '',
      fullScreen: true,
      minWidth: 800,
      minHeight: 0,
      minRefresh: 0,
      minFrameRate: 0,
      headset: 'no',
    });
  });

  it('names JATOS as the receiver, and as nothing else', () => {
    expect(settings({ receiver: 'jatos' }).receiver).toBe('jatos');
    expect(() => settings({ completion: 'jatos' })).toThrow('"completion" must be an address');
  });

  it.each(['javascript:alert(1)', 'ftp://host/', 7])('names no receiver %s', (receiver) => {
    expect(() => settings({ receiver })).toThrow('"receiver" must be an address that begins with https://');
  });

  it.each(['always', true, null])('shows nothing in a headset %s', (headset) => {
    expect(() => settings({ headset })).toThrow('"headset" must be "offer", "require" or "no"');
  });

  it.each([-1, '800', NaN])('has no width %s', (minWidth) => {
    expect(() => settings({ minWidth })).toThrow('"minWidth" must be a number, 0 or above');
  });
});

describe('the address of a study', () => {
  it('names a place of the plan from 1; any other is none', () => {
    expect(['?slot=1', '?slot=4', '?slot=0', '?slot=5', '?slot=x', ''].map((query) => askedSlot(query, 4))).toEqual([
      0, 3, undefined, undefined, undefined, undefined,
    ]);
  });

  it('tells who comes, and the completion url gets it', () => {
    const ids = recruitment('?PROLIFIC_PID=a%20b&STUDY_ID=s&other=1');
    expect(ids).toEqual({ PROLIFIC_PID: 'a b', STUDY_ID: 's' });
    expect(completion('https://host/done?who={PROLIFIC_PID}&id={id}', ids)).toBe('https://host/done?who=a%20b&id={id}');
  });

  it('names a language of the study, or the browser does, or it is the first', () => {
    expect(language('?lang=el', ['en'], ['en', 'el'])).toBe('el');
    expect(language('', ['fr', 'el-GR'], ['en', 'el'])).toBe('el');
    expect(language('?lang=fr', ['de'], ['en', 'el'])).toBe('en');
  });
});
