import { fitting, type Part, type Store } from './store.js';

const DATABASE = 'selective-renderer-data';

interface SessionRow {
  readonly session: string;
  /** The number of the next part. */
  next: number;
  ended: boolean;
  /** Whether the final part is cut. */
  complete: boolean;
}

interface RecordRow {
  readonly session: string;
  readonly text: string;
}

interface PartRow extends Part {
  readonly session: string;
}

/**
 * Keeps data in the browser's IndexedDB, where they outlive the page. Part numbers are given in the transaction that
 * takes their records, so two tabs with the same session never give one number to different parts.
 */
export class IndexedStore implements Store {
  readonly lasting = true;

  private constructor(
    private readonly database: IDBDatabase,
    private readonly session: string,
  ) {}

  /** Opens the store of a session; fails where the browser offers none. */
  static async open(factory: IDBFactory, session: string): Promise<IndexedStore> {
    const request = factory.open(DATABASE, 1);
    request.onupgradeneeded = () => {
      const database = request.result;
      database.createObjectStore('sessions', { keyPath: 'session' });
      database.createObjectStore('records', { autoIncrement: true }).createIndex('session', 'session');
      database.createObjectStore('parts', { keyPath: ['session', 'part'] });
    };
    const database = await result(request);
    database.onversionchange = () => {
      database.close();
    };
    return new IndexedStore(database, session);
  }

  close(): void {
    this.database.close();
  }

  async add(record: string): Promise<void> {
    const row: RecordRow = { session: this.session, text: record };
    await this.change(['records'], (change) => {
      change.objectStore('records').add(row);
      return Promise.resolve();
    });
  }

  async end(): Promise<void> {
    await this.change(['sessions'], async (change) => {
      const sessions = change.objectStore('sessions');
      sessions.put({ ...(await this.row(sessions)), ended: true });
    });
  }

  async next(): Promise<Part | undefined> {
    return await this.change(['sessions', 'records', 'parts'], async (change) => {
      const parts = change.objectStore('parts');
      const oldest = (await result(parts.getAll(this.range(), 1))) as PartRow[];
      return oldest[0] ?? (await this.cut(change));
    });
  }

  async answered(part: number): Promise<void> {
    await this.change(['parts'], (change) => {
      change.objectStore('parts').delete([this.session, part]);
      return Promise.resolve();
    });
  }

  async left(): Promise<string[]> {
    const read = this.database.transaction(['records', 'parts'], 'readonly');
    const parts = (await result(read.objectStore('parts').getAll(this.range()))) as PartRow[];
    const index = read.objectStore('records').index('session');
    const records = (await result(index.getAll(this.session))) as RecordRow[];
    return [...parts.flatMap((part) => part.records), ...records.map((record) => record.text)];
  }

  private async cut(change: IDBTransaction): Promise<Part | undefined> {
    const sessions = change.objectStore('sessions');
    const session = await this.row(sessions);
    const records = change.objectStore('records');
    const index = records.index('session');
    const keys = await result(index.getAllKeys(this.session));
    const texts = ((await result(index.getAll(this.session))) as RecordRow[]).map((record) => record.text);
    const count = fitting(texts);
    const final = session.ended && !session.complete && count === texts.length;
    if (count === 0 && !final) {
      return undefined;
    }
    const row: PartRow = { session: this.session, part: session.next, final, records: texts.slice(0, count) };
    change.objectStore('parts').add(row);
    for (const key of keys.slice(0, count)) {
      records.delete(key);
    }
    sessions.put({ ...session, next: session.next + 1, complete: session.complete || final });
    return row;
  }

  private async row(sessions: IDBObjectStore): Promise<SessionRow> {
    const row = (await result(sessions.get(this.session))) as SessionRow | undefined;
    return row ?? { session: this.session, next: 0, ended: false, complete: false };
  }

  private range(): IDBKeyRange {
    return IDBKeyRange.bound([this.session, 0], [this.session, Number.MAX_SAFE_INTEGER]);
  }

  /** Makes a change as a whole, and returns when it is written. */
  private async change<T>(stores: string[], work: (change: IDBTransaction) => Promise<T>): Promise<T> {
    const change = this.database.transaction(stores, 'readwrite', { durability: 'strict' });
    const written = new Promise<void>((resolve, reject) => {
      change.oncomplete = () => {
        resolve();
      };
      change.onabort = () => {
        reject(change.error ?? new Error('the browser did not keep the data'));
      };
    });
    const [value] = await Promise.all([work(change), written]);
    return value;
  }
}

function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => {
      resolve(request.result);
    };
    request.onerror = () => {
      reject(request.error ?? new Error('the browser did not answer'));
    };
  });
}
