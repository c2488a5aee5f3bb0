import { describe, expect, it } from 'vitest';
import { Controllers } from '../src/scene/controllers.js';
import { poseOf } from '../src/scene/headset.js';
import { room } from '../src/scene/rig.js';
import type { XrInputSource } from '../src/scene/webxr.js';

const UPRIGHT = { x: 0, y: 0, z: 0, yaw: 0, pitch: 0, roll: 0 };

describe('room', () => {
  it('is under the head that looks where it is to', () => {
    const wanted = { ...UPRIGHT, x: 3, y: 1.6, z: -2, yaw: 100 };
    const head = { ...UPRIGHT, x: 0.5, y: 1.6, z: 1, yaw: 10 };
    const found = room(wanted, head);
    expect(found.yaw).toBe(90);
    expect(found.y).toBe(0);
    // A quarter turn to the left takes +X to -Z, and +Z to +X.
    expect(found.x + head.z).toBeCloseTo(3);
    expect(found.z - head.x).toBeCloseTo(-2);
  });
});

describe('poseOf', () => {
  it('tells the angles of a quaternion', () => {
    const half = Math.PI / 8;
    const turn = { position: { x: 1, y: 2, z: 3 }, orientation: { x: 0, y: Math.sin(half), z: 0, w: Math.cos(half) } };
    expect(poseOf(turn)).toMatchObject({ x: 1, y: 2, z: 3, yaw: expect.closeTo(45) as number });
  });
});

function controller(handedness: 'left' | 'right', x: number, y: number, trigger = 0): XrInputSource {
  const buttons = [{ pressed: trigger > 0, value: trigger }];
  return { handedness, targetRaySpace: new EventTarget(), gamepad: { axes: [0, 0, x, y], buttons } };
}

describe('Controllers', () => {
  it('walk by the left stick and by the triggers', () => {
    const controllers = new Controllers();
    expect(controllers.intent([controller('left', 0.5, -1)])).toMatchObject({ forward: 1, sideways: 0.5 });
    expect(controllers.intent([controller('right', 0, -1)])).toMatchObject({ forward: 0, sideways: 0 });
    expect(controllers.intent([controller('right', 0, 0, 1)])).toMatchObject({ forward: 1 });
    expect(controllers.intent([controller('left', 0, 0, 0.5)])).toMatchObject({ forward: -0.5 });
    expect(controllers.intent([controller('left', 0.1, -0.1)])).toMatchObject({ forward: 0, sideways: 0 });
    expect(controllers.intent([])).toMatchObject({ forward: 0, sideways: 0 });
  });

  it('turn by the right stick once for each push', () => {
    const controllers = new Controllers();
    const pushes = [0.5, 0.8, 1, 0.6, 0.3, -0.9, -0.9, 0, 1].map((x) => controllers.snap([controller('right', x, 0)]));
    expect(pushes).toEqual([0, -30, 0, 0, 0, 30, 0, 0, -30]);
  });
});
