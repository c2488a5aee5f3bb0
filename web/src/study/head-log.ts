import type { Pose } from '../scene/pose.js';
import type { WorldEvent } from '../scene/world.js';

/** The columns of a row, which are those of the desktop's head log that a page can tell. */
export const COLUMNS = ['t', 'x', 'y', 'z', 'yaw', 'pitch', 'roll', 'frame_ms', 'visible', 'mono'] as const;

/** A record says this of an exposure. */
export interface Log {
  readonly columns: readonly string[];
  readonly rows: readonly (readonly number[])[];
  readonly events: readonly Record<string, unknown>[];
}

/** The most rows, two hours at 60 pictures per second, so that a forgotten page does not fill the memory. */
const MOST = 432_000;

/** Keeps where a participant was and looked in each frame, and what the areas and objects did. */
export class HeadLog {
  private readonly rows: number[][] = [];
  private readonly events: Record<string, unknown>[] = [];
  private last: number;

  /** @param began the time of the beginning, in milliseconds of performance.now() */
  constructor(private readonly began: number) {
    this.last = began;
  }

  /**
   * Adds a frame.
   *
   * @param now its time, in milliseconds of performance.now()
   * @param visible whether the picture is at least half as bright as it is without fading
   */
  frame(now: number, pose: Pose, visible: boolean): void {
    if (this.rows.length < MOST) {
      const angles = [pose.yaw, pose.pitch, pose.roll];
      this.rows.push([
        round((now - this.began) / 1000, 6),
        ...[pose.x, pose.y, pose.z, ...angles].map((value) => round(value, 6)),
        round(now - this.last, 3),
        visible ? 1 : 0,
        round(now / 1000, 6),
      ]);
    }
    this.last = now;
  }

  /** Leaves out frames until this time, after which the next one counts as the first. */
  pause(now: number): void {
    this.last = now;
  }

  /** Adds what the world tells, as the desktop's time line names it. */
  event(now: number, event: WorldEvent): void {
    const t = round((now - this.began) / 1000, 6);
    this.events.push(
      event.kind === 'switch'
        ? { t, event: 'switch', node: event.object, choice: event.choice }
        : { t, event: event.kind, node: event.area },
    );
  }

  /** Returns the log so far. */
  log(): Log {
    return { columns: COLUMNS, rows: this.rows, events: this.events };
  }
}

function round(value: number, decimals: number): number {
  return Number(value.toFixed(decimals));
}
