import { IndexedStore } from './indexed-store.js';
import { Outbox, PAUSES, type Pauses, type Post } from './outbox.js';
import { SessionPlace, uuid, type Session } from './session.js';
import { MemoryStore, type Part, type Store } from './store.js';

/** Takes what a study records. */
export interface DataSink {
  /** Takes a record, anything that JSON can write; it is kept and sent in the background. */
  send(record: unknown): void;
  /** Returns when all is at its place, or the participant has a file of what is not. */
  finish(): Promise<void>;
}

/** Tells participants that their data are on the way, see WaitingPage. */
export interface Waiting {
  /** Begins to tell; resolves when the participant has saved the records that are left and wants to go. */
  begin(name: string, left: () => Promise<string[]>): Promise<void>;
  /** Tells whether there is trouble. */
  trouble(trouble: string | undefined): void;
  end(): void;
}

/** A sink keeps its data here, and waits in this way. */
export interface Keeping {
  readonly study: string;
  /** Who it is, such as PROLIFIC_PID of the query; two of them never share a session of one browser. */
  readonly participant: string;
  readonly waiting: Waiting;
  readonly indexedDB?: IDBFactory | undefined;
  readonly localStorage?: Storage | undefined;
  readonly events?: EventTarget;
  readonly pauses?: Pauses;
}

/** A sink that keeps records in the browser until they have arrived, over closed and opened tabs. */
export abstract class KeptSink implements DataSink {
  private readonly outbox: Outbox;
  private readonly online = () => {
    this.outbox.retry();
  };

  protected constructor(
    protected readonly keeping: Keeping,
    private readonly kept: Kept,
    post: (session: string) => Post,
  ) {
    this.outbox = new Outbox(kept.store, post(kept.session.session), keeping.pauses ?? PAUSES, () => {
      keeping.waiting.trouble(this.outbox.trouble);
    });
    keeping.events?.addEventListener('online', this.online);
    this.outbox.start();
  }

  get session(): string {
    return this.kept.session.session;
  }

  /** Whether the session began in a tab that was closed; what it recorded is being sent. */
  get resumed(): boolean {
    return this.kept.resumed;
  }

  /** Whether the participant was at the end already: only finish() is left to be called. */
  get ended(): boolean {
    return this.kept.session.ended ?? false;
  }

  /** Whether the browser keeps data over a closed tab; if not, the participant is to be told. */
  get lasting(): boolean {
    return this.outbox.lasting;
  }

  send(record: unknown): void {
    this.outbox.add(record);
  }

  async finish(): Promise<void> {
    const { waiting } = this.keeping;
    this.remember({ ended: true });
    const all = this.outbox.end().then(() => true);
    const left = waiting.begin(`${this.session}-rest.jsonl`, () => this.outbox.left()).then(() => false);
    waiting.trouble(this.outbox.trouble);
    const sent = await Promise.race([all, left]);
    waiting.end();
    if (sent) {
      this.close();
      this.kept.place.forget();
      await this.arrived();
    }
  }

  /** Stops sending; what is kept stays for the next page. */
  close(): void {
    this.keeping.events?.removeEventListener('online', this.online);
    this.outbox.close();
  }

  /** Returns the place in the plan that the session has already. */
  protected get slotOfSession(): number | undefined {
    return this.kept.session.slot;
  }

  protected remember(more: Partial<Session>): void {
    this.kept.session = { ...this.kept.session, ...more };
    if (this.kept.store.lasting) {
      this.kept.place.write(this.kept.session);
    }
  }

  /** Ends the study where the data are. */
  protected arrived(): Promise<void> {
    return Promise.resolve();
  }
}

/** A session with its place in the browser. */
export interface Kept {
  session: Session;
  readonly resumed: boolean;
  readonly place: SessionPlace;
  readonly store: Store;
}

/** Goes on with the session that a closed tab left, or begins one. */
export async function keep(keeping: Keeping): Promise<Kept> {
  const place = new SessionPlace(keeping.localStorage, keeping.study, keeping.participant);
  const before = place.read();
  const session = before ?? { session: uuid() };
  try {
    if (keeping.indexedDB !== undefined) {
      const store = await IndexedStore.open(keeping.indexedDB, session.session);
      place.write(session);
      return { session, resumed: before !== undefined, place, store };
    }
  } catch {
    // Forbidden, as in some private windows: memory has to do, and sink.lasting says so.
  }
  // Part numbers would begin anew: a session that is kept in memory is never one of before.
  return { session: { session: uuid() }, resumed: false, place, store: new MemoryStore() };
}

/** Returns a part as it is sent. */
export function message(study: string, session: string, part: Part): string {
  const head = JSON.stringify({ study, session, part: part.part, final: part.final });
  return `${head.slice(0, -1)},"records":[${part.records.join(',')}]}`;
}
