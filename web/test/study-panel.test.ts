import { describe, expect, it } from 'vitest';
import type { Page } from '../src/study/description.js';
import { pointable } from '../src/study/headset/panel-questionnaire.js';
import { meets } from '../src/study/headset/ray.js';
import { QuestionnaireState } from '../src/study/questionnaire-state.js';

const AHEAD = { x: 0, y: 0, z: 0, w: 1 };

/** A turn about +Y to the left. */
function left(degrees: number): { x: number; y: number; z: number; w: number } {
  const half = (degrees * Math.PI) / 360;
  return { x: 0, y: Math.sin(half), z: 0, w: Math.cos(half) };
}

describe('a ray', () => {
  const panel = { x: 0, y: 1.6, z: -2, yaw: 0, pitch: 0, roll: 0 };

  it('meets a panel ahead where it points', () => {
    expect(meets({ position: { x: 0, y: 1.6, z: 0 }, orientation: AHEAD }, panel, 2, 1)).toEqual({ u: 0.5, v: 0.5 });
    const aside = meets({ position: { x: 0.5, y: 1.85, z: 0 }, orientation: AHEAD }, panel, 2, 1);
    expect(aside?.u).toBeCloseTo(0.75);
    expect(aside?.v).toBeCloseTo(0.25);
  });

  it('meets nothing beside the panel, away from it and from behind', () => {
    expect(meets({ position: { x: 1.1, y: 1.6, z: 0 }, orientation: AHEAD }, panel, 2, 1)).toBeUndefined();
    expect(meets({ position: { x: 0, y: 1.6, z: 0 }, orientation: left(180) }, panel, 2, 1)).toBeUndefined();
    expect(meets({ position: { x: 0, y: 1.6, z: -3 }, orientation: left(180) }, panel, 2, 1)).toBeUndefined();
  });

  it('meets a panel that is to the left, for who looks there', () => {
    const there = { ...panel, x: -2, z: 0, yaw: 90 };
    const seen = meets({ position: { x: 0, y: 1.6, z: -0.5 }, orientation: left(90) }, there, 2, 1);
    expect(seen?.u).toBeCloseTo(0.75); // -Z is to the right of who looks along -X
    const down = { x: -Math.sin(0.1), y: 0, z: 0, w: Math.cos(0.1) };
    expect(meets({ position: { x: 0, y: 1.6, z: 0 }, orientation: down }, panel, 2, 1)?.v).toBeCloseTo(0.5 + 2 * Math.tan(0.2));
  });
});

const CHOICE = { type: 'choice', options: [{ value: 'yes', label: 'Yes' }, { value: 'no', label: 'No' }] } as const;

function page(id: string, ...questions: Page['questions']): Page {
  return { id, questions };
}

describe('a panel', () => {
  it('asks choices and sliders, but no texts and orders', () => {
    const slider = { type: 'slider', values: ['0', '1', '2'] } as const;
    expect(pointable([page('one', { id: 'a', kind: 'choice', fields: [CHOICE, slider] })])).toBe(true);
    expect(pointable([page('one', { id: 'a', kind: 'text', fields: [{ type: 'line', lines: 1 }] })])).toBe(false);
    expect(pointable([page('one', { id: 'a', kind: 'ranking', fields: [{ type: 'ranking', options: [] }] })])).toBe(false);
  });
});

describe('the state of a questionnaire', () => {
  const pages = [
    page('first', { id: 'seen', kind: 'choice', fields: [CHOICE] },
      { id: 'where', kind: 'choice', when: { question: 'seen', is: ['yes'] }, fields: [CHOICE, CHOICE] }),
    page('last', { id: 'again', kind: 'choice', must: 'yes', fields: [CHOICE] }),
  ];

  it('goes on when all is answered, asks what earlier answers open, and tells the answers', async () => {
    const state = new QuestionnaireState(pages);
    const [seen] = state.questions;
    expect(state.next()).toBe('open');
    expect(seen && state.take(seen, { value: 'yes' })).toBe(true);
    const [, where] = state.questions;
    expect(where && state.take(where, { value: 'no' })).toBe(false);
    expect(state.next()).toBe('open'); // how sure one is of it lacks
    expect(where && state.take(where, { confidence: 'yes' })).toBe(false);
    expect(state.next()).toBe('page');
    const [again] = state.questions;
    expect(again && state.take(again, { value: 'no' })).toBe(false);
    expect(state.next()).toBe('refuses');
    expect(again && state.take(again, { value: 'yes' })).toBe(false);
    expect(state.next()).toBe('end');
    const { answers, refused } = await state.result;
    expect(refused).toBe(false);
    expect(answers).toMatchObject([
      { page: 'first', question: 'seen', value: 'yes', place: 1 },
      { page: 'first', question: 'where', value: 'no', confidence: 'yes', place: 2 },
      { page: 'last', question: 'again', value: 'yes', place: 1 },
    ]);
  });

  it('tells the places of the questions at the end, when an answer has opened one before others', async () => {
    const state = new QuestionnaireState([page('one',
      { id: 'seen', kind: 'choice', fields: [CHOICE] },
      { id: 'again', kind: 'choice', when: { question: 'seen', is: ['yes'] }, fields: [CHOICE] },
      { id: 'liked', kind: 'choice', fields: [CHOICE] })]);
    for (const id of ['liked', 'seen', 'again']) {
      const question = state.questions.find((each) => each.id === id);
      expect(question).toBeDefined();
      if (question) {
        state.take(question, { value: 'yes' });
      }
    }
    expect(state.next()).toBe('end');
    const { answers } = await state.result;
    expect(answers.map(({ question, place }) => [question, place])).toEqual([['seen', 1], ['again', 2], ['liked', 3]]);
  });

  it('has no answers when consent is refused', async () => {
    const state = new QuestionnaireState(pages);
    state.refuse();
    expect(await state.result).toEqual({ answers: [], refused: true });
  });
});
