/** What the browser keeps of a session, so that a page that was closed goes on where it was. */
export interface KeptSession {
  /** A random id of the session. */
  readonly session: string;
  readonly slot: number;
  readonly language: string;
  /** The steps that are done. */
  readonly done: readonly string[];
  /** The step that is under way; empty between steps. */
  readonly open: string;
}

/** Keeps the session of a study in the browser's local storage, as long as that has one. */
export class SessionStore {
  private readonly key: string;

  /**
   * @param study name of the study
   * @param checksum of its file: another one is another study
   * @param storage undefined where the browser keeps nothing
   */
  constructor(study: string, checksum: string, private readonly storage: Storage | undefined) {
    this.key = `selective-renderer/${checksum.slice(0, 16)}/${study}`;
  }

  /** Returns the session that was begun here; undefined for none. */
  kept(): KeptSession | undefined {
    try {
      const found = JSON.parse(this.storage?.getItem(this.key) ?? 'null') as Partial<KeptSession> | null;
      return typeof found?.session === 'string' && typeof found.slot === 'number' && Array.isArray(found.done)
        ? { open: '', language: '', ...found } as KeptSession
        : undefined;
    } catch {
      return undefined;
    }
  }

  keep(session: KeptSession): void {
    try {
      this.storage?.setItem(this.key, JSON.stringify(session));
    } catch {
      // A full or forbidden storage: the session just cannot go on in another tab.
    }
  }

  forget(): void {
    this.storage?.removeItem(this.key);
  }
}
