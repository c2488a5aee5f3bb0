/** A place and a direction of view, in the frame of the scene: metres, +Y up. */
export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** Degrees about +Y, positive to the left; 0 looks along -Z. */
  readonly yaw: number;
  /** Degrees, positive upwards. */
  readonly pitch: number;
  /** Degrees, positive when the head leans to its left. Yaw, pitch and roll compose in this order. */
  readonly roll: number;
}

/** A rotation as X3D writes it: a unit axis and an angle in radians. */
export interface AxisAngle {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly angle: number;
}

type Quaternion = readonly [x: number, y: number, z: number, w: number];

const DEGREES = 180 / Math.PI;

/** Returns the orientation of a pose. */
export function orientation(pose: Pick<Pose, 'yaw' | 'pitch' | 'roll'>): AxisAngle {
  const [x, y, z, w] = times(
    times(about(1, pose.yaw), about(0, pose.pitch)),
    about(2, pose.roll),
  );
  const sine = Math.hypot(x, y, z);
  if (sine < 1e-12) {
    return { x: 0, y: 1, z: 0, angle: 0 };
  }
  return { x: x / sine, y: y / sine, z: z / sine, angle: 2 * Math.atan2(sine, w) };
}

/** Returns yaw, pitch and roll of an orientation; straight up or down, the roll is 0. */
export function angles(turn: AxisAngle): Pick<Pose, 'yaw' | 'pitch' | 'roll'> {
  const length = Math.hypot(turn.x, turn.y, turn.z);
  const sine = length === 0 ? 0 : Math.sin(turn.angle / 2) / length;
  const [x, y, z] = [turn.x * sine, turn.y * sine, turn.z * sine];
  const w = length === 0 ? 1 : Math.cos(turn.angle / 2);
  // The entries of the rotation matrix that Ry(yaw) Rx(pitch) Rz(roll) gives a meaning to.
  const up = 2 * (w * x - y * z);
  const pitch = Math.asin(Math.min(1, Math.max(-1, up)));
  if (Math.abs(up) > 1 - 1e-9) {
    return { yaw: Math.atan2(2 * (w * y - x * z), 1 - 2 * (y * y + z * z)) * DEGREES, pitch: pitch * DEGREES, roll: 0 };
  }
  return {
    yaw: Math.atan2(2 * (x * z + w * y), 1 - 2 * (x * x + y * y)) * DEGREES,
    pitch: pitch * DEGREES,
    roll: Math.atan2(2 * (x * y + w * z), 1 - 2 * (x * x + z * z)) * DEGREES,
  };
}

/** Returns the rotation by an angle in degrees about the axis 0 (X), 1 (Y) or 2 (Z). */
function about(axis: 0 | 1 | 2, degrees: number): Quaternion {
  const half = degrees / DEGREES / 2;
  const sine = Math.sin(half);
  return [axis === 0 ? sine : 0, axis === 1 ? sine : 0, axis === 2 ? sine : 0, Math.cos(half)];
}

function times([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}
