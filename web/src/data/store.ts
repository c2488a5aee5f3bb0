/** A numbered piece of a session's data: it is sent as a whole and never changes once it is cut. */
export interface Part {
  readonly part: number;
  readonly final: boolean;
  /** The records, each as JSON. */
  readonly records: readonly string[];
}

/** Keeps the data of one session until the receiver has them. */
export interface Store {
  /** Whether the data outlive the page. */
  readonly lasting: boolean;
  add(record: string): Promise<void>;
  /** Notes that no record follows: the part which takes the last one is the final part. */
  end(): Promise<void>;
  /** Returns the oldest part that was not answered, or cuts a new one from the records; undefined if all is there. */
  next(): Promise<Part | undefined>;
  /** Forgets a part that the receiver has. */
  answered(part: number): Promise<void>;
  /** Returns all records that were not answered. */
  left(): Promise<string[]>;
}

/** Bytes of records that a part takes, unless one alone has more. */
const PART_BYTES = 1 << 20;

/** Returns how many of the first records go into a part. */
export function fitting(records: readonly string[]): number {
  const encoder = new TextEncoder();
  let bytes = 0;
  let count = 0;
  for (const record of records) {
    bytes += encoder.encode(record).length;
    if (count > 0 && bytes > PART_BYTES) {
      break;
    }
    count++;
  }
  return count;
}

/** Keeps data in memory, for browsers that offer no place. */
export class MemoryStore implements Store {
  readonly lasting = false;
  private readonly records: string[] = [];
  private readonly parts: Part[] = [];
  private parted = 0;
  private ended = false;
  private complete = false;

  add(record: string): Promise<void> {
    this.records.push(record);
    return Promise.resolve();
  }

  end(): Promise<void> {
    this.ended = true;
    return Promise.resolve();
  }

  next(): Promise<Part | undefined> {
    if (this.parts.length === 0) {
      const records = this.records.splice(0, fitting(this.records));
      const final = this.ended && !this.complete && this.records.length === 0;
      if (records.length > 0 || final) {
        this.parts.push({ part: this.parted++, final, records });
        this.complete ||= final;
      }
    }
    return Promise.resolve(this.parts[0]);
  }

  answered(part: number): Promise<void> {
    const found = this.parts.findIndex((one) => one.part === part);
    if (found >= 0) {
      this.parts.splice(found, 1);
    }
    return Promise.resolve();
  }

  left(): Promise<string[]> {
    return Promise.resolve([...this.parts.flatMap((part) => part.records), ...this.records]);
  }
}
