import { describe, expect, it } from 'vitest';
import { FrameRate } from '../src/study/frame-rate.js';

/** Measures pictures of these lengths, in milliseconds; returns how many it took, and the rate. */
function measured(lengths: readonly number[]): { taken: number; rate: number } {
  const rate = new FrameRate(1, 10, 5);
  let time = 100;
  let taken = 1;
  rate.picture(time);
  for (const length of lengths) {
    time += length;
    taken++;
    if (rate.picture(time)) {
      break;
    }
  }
  return { taken, rate: rate.perSecond() };
}

describe('the rate of a scene', () => {
  it('is that of a second after the first pictures, which a hitch does not change', () => {
    const lengths = [800, 300, 200, 90, 90, ...new Array<number>(30).fill(20), 400, ...new Array<number>(60).fill(20)];
    const { taken, rate } = measured(lengths);
    expect(rate).toBe(50);
    expect(taken).toBe(6 + 30 + 1);
  });

  it('is told of a slow device after a few seconds', () => {
    expect(measured([2500, 2500, 2500])).toEqual({ taken: 3, rate: 0.4 });
  });

  it('is none without pictures', () => {
    expect(new FrameRate(1, 10, 5).perSecond()).toBe(0);
  });
});
