import type { Pose } from './pose.js';
import type { XrInputSource } from './webxr.js';

/** A headset that is worn: it carries the eyes about a room, which the viewpoint carries about the scene. */
export interface Rig {
  /** Where the head is in the room: metres from the room's origin, +Y up; degrees. */
  head(): Pose;
  /** How far below the eyes of a walker the origin of the room is, in metres: 0, or their height if it is on the floor. */
  readonly drop: number;
  /** The controllers, hands and what else points. */
  readonly inputs: readonly XrInputSource[];
}

/** Returns where the room must be for the head to be at a place and to look in its direction; a room stays upright. */
export function room(wanted: Pose, head: Pose): Pose {
  const yaw = wanted.yaw - head.yaw;
  const [sine, cosine] = [Math.sin((yaw * Math.PI) / 180), Math.cos((yaw * Math.PI) / 180)];
  return {
    x: wanted.x - head.x * cosine - head.z * sine,
    y: wanted.y - head.y,
    z: wanted.z + head.x * sine - head.z * cosine,
    yaw,
    pitch: 0,
    roll: 0,
  };
}
