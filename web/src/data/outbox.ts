import type { Part, Store } from './store.js';

/** Sends a part; fails if it is not sure that the receiver has it. */
export type Post = (part: Part) => Promise<void>;

/** An outbox pauses so many milliseconds after a failure; each pause is twice the one before. */
export interface Pauses {
  readonly first: number;
  readonly longest: number;
}

export const PAUSES: Pauses = { first: 1000, longest: 60_000 };

/**
 * Keeps records until the receiver has answered, and sends them in parts, one after the other. After a failure it
 * pauses, longer each time, and sends the same part again: the receiver stores it once.
 */
export class Outbox {
  private readonly unsaved: string[] = [];
  private ending = false;
  private sent = false;
  private saving = false;
  private sending = false;
  private closed = false;
  private failures = 0;
  private asked = 0;
  private readonly skips = new Set<() => void>();
  private readonly waiting: (() => void)[] = [];

  /** The last failure, until something is answered again. */
  trouble: string | undefined;

  constructor(
    private readonly store: Store,
    private readonly post: Post,
    private readonly pauses: Pauses = PAUSES,
    private readonly changed: () => void = () => undefined,
  ) {}

  /** Whether what is kept outlives the page. */
  get lasting(): boolean {
    return this.store.lasting;
  }

  /** Keeps a record and sends it as soon as it can be. */
  add(record: unknown): void {
    if (this.ending) {
      throw new Error('a record after the end');
    }
    this.unsaved.push(JSON.stringify(record));
    void this.save();
  }

  /** Sends what an earlier page left, and returns at once. */
  start(): void {
    void this.send();
  }

  /** Sends the rest, with a final part, and returns when the receiver has all. */
  async end(): Promise<void> {
    this.ending = true;
    void this.save();
    while (!this.sent) {
      await new Promise<void>((resolve) => this.waiting.push(resolve));
    }
  }

  /** Tries again now, such as when the browser is online again. */
  retry(): void {
    this.skips.forEach((skip) => {
      skip();
    });
    void this.save();
  }

  /** Returns all records that the receiver did not answer. */
  async left(): Promise<string[]> {
    return [...(await this.store.left()), ...this.unsaved];
  }

  /** Stops sending; what is kept stays. */
  close(): void {
    this.closed = true;
    this.skips.forEach((skip) => {
      skip();
    });
  }

  private async save(): Promise<void> {
    if (this.saving) {
      return;
    }
    this.saving = true;
    while (this.unsaved.length > 0 && !this.closed) {
      try {
        await this.store.add(this.unsaved[0] ?? '');
        this.unsaved.shift();
      } catch (e) {
        // Such as no room: the record stays in memory, and what is sent meanwhile makes room.
        this.failed(e);
        void this.send();
        await this.pause();
      }
    }
    this.saving = false;
    void this.send();
  }

  private async send(): Promise<void> {
    this.asked++;
    if (this.sending) {
      return;
    }
    this.sending = true;
    while (!this.closed && !this.sent) {
      // Asked for before next(): what is saved while next() reads takes another round.
      const asked = this.asked;
      const last = this.ending && this.unsaved.length === 0;
      try {
        if (last) {
          await this.store.end();
        }
        const part = await this.store.next();
        if (part !== undefined) {
          await this.post(part);
          await this.store.answered(part.part);
          this.failures = 0;
          this.trouble = undefined;
          this.changed();
        } else if (last) {
          this.sent = true;
        } else if (asked === this.asked) {
          break;
        }
      } catch (e) {
        this.failed(e);
        await this.pause();
      }
    }
    this.sending = false;
    if (this.sent) {
      this.waiting.splice(0).forEach((resolve) => {
        resolve();
      });
    }
  }

  private failed(e: unknown): void {
    this.failures++;
    this.trouble = e instanceof Error ? e.message : String(e);
    this.changed();
  }

  private async pause(): Promise<void> {
    // Between half and all of it: participants who lost the same server do not come back at the same moment.
    const longest = Math.min(this.pauses.longest, this.pauses.first * 2 ** Math.min(this.failures - 1, 20));
    await new Promise<void>((resolve) => {
      const skip = () => {
        clearTimeout(timer);
        this.skips.delete(skip);
        resolve();
      };
      const timer = setTimeout(skip, longest * (0.5 + Math.random() / 2));
      this.skips.add(skip);
    });
  }
}
