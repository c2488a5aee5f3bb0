import type { Pose } from './pose.js';

/** What keys, mouse and fingers ask for at an instant. */
export interface Intent {
  /** From -1 (backward) to 1 (forward). */
  readonly forward: number;
  /** From -1 (to the left) to 1 (to the right). */
  readonly sideways: number;
  /** Degrees per second, positive to the left. */
  readonly turning: number;
  readonly fast: boolean;
  /** By how much the speed of the scene is multiplied. */
  readonly factor: number;
}

export interface Step {
  readonly x: number;
  readonly z: number;
}

/** Degrees per second that a held arrow key turns the view. */
export const TURN_SPEED = 60;

/** The steepest look up and down, in degrees: a person does not turn over. */
const STEEPEST = 85;

const FAST = 3;

/** Returns the horizontal way, in metres, that a walker takes in a time: as fast aslant as ahead. */
export function step(pose: Pose, intent: Intent, speed: number, seconds: number): Step {
  const length = Math.hypot(intent.forward, intent.sideways);
  if (length === 0) {
    return { x: 0, z: 0 };
  }
  const metres = (speed * seconds * intent.factor * (intent.fast ? FAST : 1)) / Math.max(1, length);
  const yaw = (pose.yaw * Math.PI) / 180;
  return {
    x: metres * (intent.sideways * Math.cos(yaw) - intent.forward * Math.sin(yaw)),
    z: metres * (-intent.sideways * Math.sin(yaw) - intent.forward * Math.cos(yaw)),
  };
}

/** Returns a pose turned by degrees to the left and upwards. */
export function turned(pose: Pose, left: number, up: number): Pose {
  const yaw = ((((pose.yaw + left + 180) % 360) + 360) % 360) - 180;
  return { ...pose, yaw, pitch: Math.min(STEEPEST, Math.max(-STEEPEST, pose.pitch + up)), roll: 0 };
}

/**
 * Returns how far a walker rises or sinks in a time so that the eyes come to their height above the floor.
 *
 * @param height the distance from the eyes straight down to the floor, in metres; undefined where none is near
 * @param eyes the height of the eyes, in metres
 * @param stairs the highest step that the walker climbs, in metres
 */
export function rise(height: number | undefined, eyes: number, stairs: number, seconds: number): number {
  if (height === undefined) {
    return 0;
  }
  const wanted = eyes - height;
  if (wanted > stairs || Math.abs(wanted) < 0.005) {
    return 0;
  }
  const most = 4 * seconds; // m/s: quick, and yet seen as a way and not as a jump
  return Math.min(most, Math.max(-most, wanted));
}
