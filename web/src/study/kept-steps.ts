/** The browser keeps this of how far a session is, so that a page that was closed goes on where it was. */
export interface KeptSteps {
  readonly language: string;
  /** The steps that are done, and the trials of blocks. */
  readonly done: readonly string[];
  /** The trials among them whose response was wrong. */
  readonly wrong?: readonly string[];
  /** The step that is under way; empty between steps. */
  readonly open: string;
}

/** The place of a session's steps in the browser. */
export class StepsPlace {
  private readonly key: string;

  /** @param storage undefined where the browser keeps nothing */
  constructor(private readonly storage: Storage | undefined, session: string) {
    this.key = `selective-renderer-steps:${session}`;
  }

  /** Returns how far the session was; undefined where nothing is known of it. */
  read(): KeptSteps | undefined {
    try {
      const found = JSON.parse(this.storage?.getItem(this.key) ?? 'null') as Partial<KeptSteps> | null;
      return typeof found?.language === 'string' && Array.isArray(found.done) && typeof found.open === 'string'
        ? (found as KeptSteps)
        : undefined;
    } catch {
      return undefined;
    }
  }

  write(steps: KeptSteps): void {
    try {
      this.storage?.setItem(this.key, JSON.stringify(steps));
    } catch {
      // Full or forbidden: a page that is opened again begins at the first step.
    }
  }

  forget(): void {
    try {
      this.storage?.removeItem(this.key);
    } catch {
      // As above.
    }
  }
}
