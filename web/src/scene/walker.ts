import { Controllers } from './controllers.js';
import type { Input } from './input.js';
import { rise, step, turned } from './walk.js';
import type { World } from './world.js';

/** The longest time that one frame walks, in seconds, so that nobody is carried through a wall after a pause. */
const LONGEST = 0.1;

/** How far a head in a headset walks until the floor below it is looked for, in metres. */
const PACE = 0.1;

/** Moves the viewer of a world as keys, mouse and fingers want, and as the controllers of a headset do. */
export class Walker {
  /** Whether the viewer is moved; a path that is replayed switches this off. */
  walks = true;

  /** Whether the viewer keeps its place and only turns. */
  stays = false;

  private last = performance.now();
  private still = 0;
  private stood = { x: 0, z: 0 };
  private readonly controllers = new Controllers();

  constructor(
    private readonly world: World,
    private readonly input: Input,
  ) {}

  /** Moves the viewer by what was wanted since the last call. */
  move(): void {
    const now = performance.now();
    const seconds = Math.min(LONGEST, (now - this.last) / 1000);
    this.last = now;
    const worn = this.world.worn;
    const intent = worn ? this.controllers.intent(worn.inputs) : this.input.intent();
    const drag = this.input.dragged();
    const left = worn ? this.controllers.snap(worn.inputs) : intent.turning * seconds + drag.left;
    if (!this.walks) {
      return;
    }
    const moves = !this.stays && (intent.forward !== 0 || intent.sideways !== 0);
    const at = this.world.pose();
    const walked = worn !== undefined && Math.hypot(at.x - this.stood.x, at.z - this.stood.z) > PACE;
    // Looking for the floor draws the scene once more: after a step, and until the eyes are at their height.
    this.still = moves || walked ? 0 : this.still + 1;
    if (!moves && left === 0 && (worn || drag.up === 0) && (this.stays || this.still > 30)) {
      return; // who only turns is not placed anew where a sensor says
    }
    if (this.still === 0) {
      this.stood = at;
    }
    // A head in a headset is turned as a whole; what it looks up and down is its own.
    let pose = worn ? { ...at, yaw: at.yaw + left } : turned(at, left, drag.up);
    const how = this.world.walker();
    if (moves) {
      const wanted = step(pose, intent, how.speed, seconds);
      const way = this.world.free(wanted.x, wanted.z);
      pose = { ...pose, x: pose.x + way.x, z: pose.z + way.z };
    }
    if (!this.stays && this.still <= 30) {
      pose = { ...pose, y: pose.y + rise(this.world.floor(), how.eyes, how.stairs, seconds) };
    }
    this.world.setPose(pose);
  }
}
