/** The browser remembers this of a participant's session with a study. */
export interface Session {
  /** A random UUID. */
  readonly session: string;
  readonly slot?: number;
  /** Whether the participant came to the end; what was not sent then is still sent. */
  readonly ended?: boolean;
}

/** The place of a session in the browser, by study and participant. */
export class SessionPlace {
  private readonly key: string;

  constructor(
    private readonly storage: Storage | undefined,
    study: string,
    participant: string,
  ) {
    this.key = `selective-renderer:${JSON.stringify([study, participant])}`;
  }

  /** Returns the session that began here and is not sent completely. */
  read(): Session | undefined {
    try {
      const found = JSON.parse(this.storage?.getItem(this.key) ?? 'null') as Session | null;
      return typeof found?.session === 'string' ? found : undefined;
    } catch {
      return undefined;
    }
  }

  /** Remembers a session, where the browser lets us. */
  write(session: Session): void {
    try {
      this.storage?.setItem(this.key, JSON.stringify(session));
    } catch {
      // Full or forbidden: a tab that is opened again begins a new session; nothing that was recorded is lost by that.
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

/** Returns a random UUID; crypto.randomUUID is not there for pages of plain http. */
export function uuid(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  bytes[6] = ((bytes[6] ?? 0) & 0x0f) | 0x40;
  bytes[8] = ((bytes[8] ?? 0) & 0x3f) | 0x80;
  const hex = Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
  return [hex.slice(0, 8), hex.slice(8, 12), hex.slice(12, 16), hex.slice(16, 20), hex.slice(20)].join('-');
}
