import { describe, expect, it } from 'vitest';
import { rising } from '../src/page/progress.js';
import type { Trial } from '../src/study/description.js';
import { BlockProgress, type BlockStep } from '../src/study/trials/block-progress.js';

const trial = (line: number): Trial => ({
  block: 'main', levels: {}, line, stimulus: {}, scene: 'scene', viewpoint: '', condition: 'high', choices: {}, stay: 'turn',
});
const STUDY = { trials: [trial(2), trial(3), trial(4)] };

function run(progress: BlockProgress, correct: (number: number) => boolean): string[] {
  const ids: string[] = [];
  for (let next = progress.next(), i = 0; next; next = progress.next(), i++) {
    ids.push(`${next.id}:${next.trial.line}${next.rest ? ' rest' : ''}`);
    progress.add(next, correct(i));
  }
  return ids;
}

function progress(step: Partial<BlockStep>, rounds: readonly (readonly number[])[], done: string[] = [], wrong: string[] = []): BlockProgress {
  return new BlockProgress({ kind: 'block', rest: 0, ...step }, STUDY, { trials: { main: rounds } }, 'main', new Set(done), new Set(wrong));
}

describe('a block', () => {
  it('goes through the trials of the plan, with rests between them', () => {
    const block = progress({ rest: 2 }, [[2, 0, 1]]);
    expect(run(block, () => false)).toEqual(['main-001:4', 'main-002:2', 'main-003:3 rest']);
    expect(block.failed).toBe(false);
  });

  it('goes on with the trial that a closed page left', () => {
    expect(run(progress({}, [[0, 1, 2]], ['main-001']), () => true)).toEqual(['main-002:3', 'main-003:4']);
  });

  it('tells how many trials are left of a round, and whether some are over', () => {
    const whole = progress({}, [[0, 1, 2]]);
    expect([whole.left.length, whole.begun]).toEqual([3, false]);
    const rest = progress({}, [[0, 1, 2]], ['main-001']);
    expect([rest.left.length, rest.begun]).toEqual([2, true]);
    const again = progress({ practice: { correct: 1, rounds: 2 } }, [[0, 1], [2, 1]], ['main-001', 'main-002'], ['main-001']);
    expect([again.left.length, again.begun]).toEqual([2, false]);
  });

  it('repeats a practice until it is passed', () => {
    const practice = { correct: 0.5, rounds: 3 };
    const rounds = [[0, 1], [1, 0], [0, 2]];
    const second = progress({ practice }, rounds);
    expect(run(second, (i) => i >= 2)).toEqual(['main-001:2', 'main-002:3', 'main-round2-001:3', 'main-round2-002:2']);
    expect(second.failed).toBe(false);
    const never = progress({ practice }, rounds);
    expect(run(never, () => false)).toHaveLength(6);
    expect(never.failed).toBe(true);
  });

  it('knows after an interruption which responses were wrong', () => {
    const block = progress({ practice: { correct: 1, rounds: 2 } }, [[0], [1]], ['main-001'], ['main-001']);
    expect(block.next()?.id).toBe('main-round2-001');
  });

  it('needs the trials that its plan names', () => {
    expect(() => progress({}, [[7]])).toThrow('export the study anew');
  });
});

it('tells no percentage that is lower than one before', () => {
  const told: number[] = [];
  const say = rising((percent) => { told.push(percent); });
  [0, 40, 100, 0, 60, 100].forEach(say);
  expect(told).toEqual([0, 40, 100]);
});
