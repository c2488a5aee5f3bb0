import { describe, expect, it } from 'vitest';
import { rise, step, turned, type Intent } from '../src/scene/walk.js';

const HERE = { x: 1, y: 2, z: 3, yaw: 0, pitch: 0, roll: 0 };
const STILL: Intent = { forward: 0, sideways: 0, turning: 0, fast: false, factor: 1 };

describe('step', () => {
  it('leads along -Z where the yaw is 0, and along -X a quarter turn to the left', () => {
    expect(step(HERE, { ...STILL, forward: 1 }, 1.5, 2)).toEqual({ x: expect.closeTo(0) as number, z: -3 });
    const left = step({ ...HERE, yaw: 90 }, { ...STILL, forward: 1 }, 1.5, 2);
    expect(left.x).toBeCloseTo(-3);
    expect(left.z).toBeCloseTo(0);
  });

  it('leads to the right along +X', () => {
    expect(step(HERE, { ...STILL, sideways: 1 }, 1, 1)).toEqual({ x: 1, z: expect.closeTo(0) as number });
  });

  it('is as long aslant as ahead, three times as long with Shift, and shorter for a stick half pushed', () => {
    const length = (intent: Partial<Intent>): number => {
      const way = step(HERE, { ...STILL, ...intent }, 1, 1);
      return Math.hypot(way.x, way.z);
    };
    expect(length({ forward: 1, sideways: 1 })).toBeCloseTo(1);
    expect(length({ forward: 1, fast: true })).toBeCloseTo(3);
    expect(length({ forward: 0.5 })).toBeCloseTo(0.5);
    expect(length({ forward: 1, factor: 2 })).toBeCloseTo(2);
    expect(length({})).toBe(0);
  });
});

describe('turned', () => {
  it('keeps the yaw from -180 to 180 and does not turn over', () => {
    expect(turned({ ...HERE, yaw: 170 }, 20, 0).yaw).toBeCloseTo(-170);
    expect(turned({ ...HERE, yaw: -170 }, -380, 0).yaw).toBeCloseTo(170);
    expect(turned(HERE, 0, 500).pitch).toBe(85);
    expect(turned(HERE, 0, -500).pitch).toBe(-85);
  });
});

describe('rise', () => {
  it('brings the eyes to their height, not faster than 4 m/s', () => {
    expect(rise(1.5, 1.6, 0.3, 1)).toBeCloseTo(0.1);
    expect(rise(2.6, 1.6, 0.3, 0.1)).toBeCloseTo(-0.4);
  });

  it('does not climb what is higher than a stair, and stays where there is no floor', () => {
    expect(rise(0.5, 1.6, 0.3, 1)).toBe(0);
    expect(rise(undefined, 1.6, 0.3, 1)).toBe(0);
  });
});
