import { describe, expect, it } from 'vitest';
import { angles, orientation } from '../src/scene/pose.js';

describe('orientation', () => {
  it('is that of the office viewpoint for its yaw and pitch', () => {
    // scenes/apartment.x3d, OfficeView: orientation='-0.1196 -0.9882 -0.0952 1.3554'
    const found = angles({ x: -0.1196, y: -0.9882, z: -0.0952, angle: 1.3554 });
    const turn = orientation(found);
    const sign = turn.y < 0 ? 1 : -1;
    expect(sign * turn.x).toBeCloseTo(-0.1196, 3);
    expect(sign * turn.angle).toBeCloseTo(1.3554, 3);
    expect(found.roll).toBeCloseTo(0, 1);
  });

  it('turns to the left by a positive yaw and up by a positive pitch', () => {
    expect(orientation({ yaw: 90, pitch: 0, roll: 0 })).toMatchObject({ y: 1, angle: expect.closeTo(Math.PI / 2) as number });
    expect(orientation({ yaw: 0, pitch: 30, roll: 0 })).toMatchObject({ x: 1, angle: expect.closeTo(Math.PI / 6) as number });
    expect(orientation({ yaw: 0, pitch: 0, roll: 0 })).toEqual({ x: 0, y: 1, z: 0, angle: 0 });
  });

  it.each([
    [0, 0, 0],
    [135, -20, 0],
    [-170, 40, 10],
    [179, -89, 0],
    [30, 60, -120],
  ])('of yaw %d, pitch %d, roll %d has these angles', (yaw, pitch, roll) => {
    const found = angles(orientation({ yaw, pitch, roll }));
    expect(found.yaw).toBeCloseTo(yaw, 6);
    expect(found.pitch).toBeCloseTo(pitch, 6);
    expect(found.roll).toBeCloseTo(roll, 6);
  });

  it('straight up has a yaw and no roll', () => {
    const found = angles(orientation({ yaw: 25, pitch: 90, roll: 0 }));
    expect(found.pitch).toBeCloseTo(90, 4);
    expect(found.yaw).toBeCloseTo(25, 4);
    expect(found.roll).toBe(0);
  });

  it('without an axis is that of no turn', () => {
    expect(angles({ x: 0, y: 0, z: 0, angle: 2 })).toEqual({ yaw: 0, pitch: 0, roll: 0 });
  });
});
