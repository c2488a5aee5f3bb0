import { describe, expect, it } from 'vitest';
import type { Phase } from '../src/study/description.js';
import { keyName } from '../src/study/trials/key-name.js';
import { filled, TrialCourse } from '../src/study/trials/trial-course.js';

const TRIAL = { levels: { change: 'colour' }, stimulus: { side: 'j', object: 'Vase' } };

/** Frames of 0.1 s, in which keys go down at their times; returns what is shown in each. */
function play(course: TrialCourse, seconds: number, keys: Readonly<Record<number, string>> = {}): (string | undefined)[] {
  const shown: (string | undefined)[] = [];
  for (let frame = 0; frame <= seconds * 10; frame++) {
    course.frame(frame / 10);
    shown.push(course.phase?.show);
    const key = keys[frame];
    if (key !== undefined) {
      course.key(key, frame / 10 + 0.05);
    }
  }
  return shown;
}

const KEYS = { keys: ['f', 'j'], correct: '{side}' };

describe('a trial', () => {
  it('goes through its phases, each ended by the frame that is nearest to its end', () => {
    const phases: Phase[] = [
      { show: 'fixation', seconds: 0.2 },
      { show: 'exposure', seconds: 0.34, choices: {} },
      { show: 'blank', seconds: 0 },
    ];
    const course = new TrialCourse(TRIAL, phases);
    expect(play(course, 0.6)).toEqual(['fixation', 'fixation', 'exposure', 'exposure', 'exposure', undefined, undefined]);
    expect(course.over).toBe(true);
    expect(course.times).toEqual([
      { phase: 'fixation', began: 0, seconds: 0.2 },
      { phase: 'exposure', began: 0.2, seconds: 0.3 },
      { phase: 'blank', began: 0.5, seconds: 0 },
    ]);
    expect(course.result()).toEqual({});
  });

  it('times the response from the first phase with keys, which passes later ones over', () => {
    const phases: Phase[] = [
      { show: 'exposure', seconds: 0.2, choices: {}, ...KEYS },
      { show: 'blank', ...KEYS },
      { show: 'exposure', seconds: 0.5, choices: {}, ...KEYS },
      { show: 'feedback', seconds: 0.2, correct: 'Right: {object}', wrong: 'Wrong', missing: 'Late' },
    ];
    const course = new TrialCourse(TRIAL, phases);
    expect(play(course, 0.6, { 3: 'x', 4: 'j' }).slice(0, 6))
      .toEqual(['exposure', 'exposure', 'blank', 'blank', 'blank', 'feedback']);
    expect(course.phase?.show === 'feedback' && course.feedback(course.phase)).toBe('Right: Vase');
    expect(course.result()).toEqual({ response: 'j', ms: 450, correct: true });
  });

  it('repeats phases until there is a response, or the rounds are over', () => {
    const phases: Phase[] = [
      { show: 'repeat', most: 2, phases: [{ show: 'exposure', seconds: 0.1, choices: {}, ...KEYS }, { show: 'blank', seconds: 0.1, ...KEYS }] },
      { show: 'feedback', seconds: 0.1, correct: 'Right', wrong: 'Wrong', missing: '' },
    ];
    const silent = new TrialCourse(TRIAL, phases);
    expect(play(silent, 0.4)).toEqual(['exposure', 'blank', 'exposure', 'blank', 'feedback']);
    expect(silent.phase?.show === 'feedback' && silent.feedback(silent.phase)).toBe('Wrong');
    expect(silent.result()).toEqual({ correct: false });
    const pressed = new TrialCourse(TRIAL, phases);
    expect(play(pressed, 0.2, { 1: 'f' })).toEqual(['exposure', 'blank', 'feedback']);
    expect(pressed.result()).toEqual({ response: 'f', ms: 150, correct: false });
  });

  it('waits for instructions to be read and for questions to be answered', () => {
    const course = new TrialCourse(TRIAL, [{ show: 'instruction', text: 'Look' }, { show: 'questions', questionnaire: 'sure' }]);
    expect(play(course, 1, { 3: 'x' }).at(-1)).toBe('instruction');
    expect(course.key('space', 1)).toBe(true);
    course.frame(1.1);
    expect(course.phase?.show).toBe('questions');
    expect(course.key('space', 1.1)).toBe(false);
    course.questionsAnswered();
    course.frame(1.2);
    expect(course.over).toBe(true);
  });

  it('lasts as long as the trial says where an exposure does not', () => {
    const course = new TrialCourse({ levels: {}, seconds: 0.2 }, [{ show: 'exposure', choices: {} }]);
    expect(play(course, 0.3)).toEqual(['exposure', 'exposure', undefined, undefined]);
  });
});

it('fills levels and cells into texts', () => {
  expect(filled(TRIAL, '{object}: {change}, {other}')).toBe('Vase: colour, {other}');
});

it('names keys as studies do, also on a Greek keyboard', () => {
  expect([
    { key: 'F', code: 'KeyF' },
    { key: 'φ', code: 'KeyF' },
    { key: 'a', code: 'KeyQ' },
    { key: ' ', code: 'Space' },
    { key: 'ArrowLeft', code: 'ArrowLeft' },
    { key: '3', code: 'Numpad3' },
    { key: 'Shift', code: 'ShiftLeft' },
  ].map(keyName)).toEqual(['f', 'f', 'a', 'space', 'left', '3', '']);
});
