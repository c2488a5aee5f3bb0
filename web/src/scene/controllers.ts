import type { Intent } from './walk.js';
import type { XrInputSource } from './webxr.js';

/** Degrees by which a push of the right stick turns, as the command run does. */
const SNAP = 30;

/** How far a stick is pushed until it turns, and how near to its middle it must come before it turns again. */
const PUSHED = 0.7;
const LET_GO = 0.4;

/** What a stick says that nobody touches. */
const STILL = 0.15;

/** The indices of WebXR's "xr-standard" mapping. */
const TRIGGER = 0;
const STICK_X = 2;
const STICK_Y = 3;

/** Turns the controllers of a headset into what the viewer wants, as the command run does with OpenXR. */
export class Controllers {
  private pushed = false;

  /** Returns the way that is wanted now: left stick, or triggers (right forward, left backward). */
  intent(inputs: readonly XrInputSource[]): Intent {
    const left = stick(inputs, 'left');
    return {
      forward: clamp(-left.y + trigger(inputs, 'right') - trigger(inputs, 'left')),
      sideways: left.x,
      turning: 0,
      fast: false,
      factor: 1,
    };
  }

  /** Returns by how many degrees to the left the right stick turns now, in steps. */
  snap(inputs: readonly XrInputSource[]): number {
    const { x } = stick(inputs, 'right');
    if (this.pushed) {
      this.pushed = Math.abs(x) > LET_GO;
      return 0;
    }
    this.pushed = Math.abs(x) >= PUSHED;
    return this.pushed ? -Math.sign(x) * SNAP : 0;
  }
}

function stick(inputs: readonly XrInputSource[], hand: 'left' | 'right'): { x: number; y: number } {
  const axes = inputs.find((input) => input.handedness === hand)?.gamepad?.axes;
  return { x: moved(axes?.[STICK_X]), y: moved(axes?.[STICK_Y]) };
}

function moved(axis = 0): number {
  return Math.abs(axis) < STILL ? 0 : clamp(axis);
}

function trigger(inputs: readonly XrInputSource[], hand: 'left' | 'right'): number {
  const button = inputs.find((input) => input.handedness === hand)?.gamepad?.buttons[TRIGGER];
  return button?.pressed ? button.value : 0;
}

function clamp(value: number): number {
  return Math.min(1, Math.max(-1, value));
}
