// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { Input } from '../src/scene/input.js';
import type { Pose } from '../src/scene/pose.js';
import { Walker } from '../src/scene/walker.js';
import type { World } from '../src/scene/world.js';

/** A world whose sensor tells of eyes that are higher than they were placed. */
function lifted(by: number): World {
  let pose: Pose = { x: 1, y: -0.746, z: 2, yaw: 30, pitch: -10, roll: 0 };
  return {
    pose: () => pose,
    setPose: (placed: Pose) => { pose = { ...placed, y: placed.y + by }; },
    walker: () => ({ speed: 1, radius: 0.25, eyes: 1.2, stairs: 0.3 }),
    floor: () => 1.2,
    free: (x: number, z: number) => ({ x, z }),
  } as unknown as World;
}

describe('a walker who stays', () => {
  it('is left where it is while nothing turns it', () => {
    const world = lifted(0.01471);
    const walker = new Walker(world, new Input(document.createElement('div'), new AbortController().signal));
    walker.stays = true;
    for (let frame = 0; frame < 8; frame++) {
      walker.move();
    }
    expect(world.pose().y).toBe(-0.746);
  });
});
