import type { Input } from './input.js';
import { rise, step, turned } from './walk.js';
import type { World } from './world.js';

/** The longest time that one frame walks, in seconds, so that nobody is carried through a wall after a pause. */
const LONGEST = 0.1;

/** Moves the viewer of a world as keys, mouse and fingers want. */
export class Walker {
  /** Whether the viewer is moved; a path that is replayed switches this off. */
  walks = true;

  /** Whether the viewer keeps its place and only turns. */
  stays = false;

  private last = performance.now();
  private still = 0;

  constructor(
    private readonly world: World,
    private readonly input: Input,
  ) {}

  /** Moves the viewer by what was wanted since the last call. */
  move(): void {
    const now = performance.now();
    const seconds = Math.min(LONGEST, (now - this.last) / 1000);
    this.last = now;
    const intent = this.input.intent();
    const drag = this.input.dragged();
    if (!this.walks) {
      return;
    }
    const moves = !this.stays && (intent.forward !== 0 || intent.sideways !== 0);
    const turns = intent.turning !== 0 || drag.left !== 0 || drag.up !== 0;
    // Looking for the floor draws the scene once more: after a step, and until the eyes are at their height.
    this.still = moves ? 0 : this.still + 1;
    if (!moves && !turns && this.still > 30) {
      return;
    }
    let pose = turned(this.world.pose(), intent.turning * seconds + drag.left, drag.up);
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
