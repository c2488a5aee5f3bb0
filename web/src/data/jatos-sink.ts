import { keep, KeptSink, message, type Keeping, type Kept } from './sink.js';

/** The page uses this of jatos.js, which JATOS serves beside it; its reference tells more. */
export interface Jatos {
  readonly studyResultId: string | number;
  appendResultData(data: string): PromiseLike<unknown>;
  /** The query of the address that the participant came by. */
  readonly urlQueryParameters?: Readonly<Record<string, unknown>>;
  onLoad(ready: () => void): void;
  /** Ends the run and keeps the page; the name since version 3.9.7. */
  endStudyWithoutRedirect?(successful: boolean): PromiseLike<unknown>;
  /** The same, the name before. */
  endStudyAjax?(successful: boolean): PromiseLike<unknown>;
  readonly batchSession: {
    get(name: string): unknown;
    set(name: string, value: unknown): PromiseLike<unknown>;
  };
}

/** A place is asked for so many times when others take one at the same time. */
const ATTEMPTS = 50;

/**
 * Sends data to JATOS: the result data get a line for each part, the same JSON that a receiver gets. A part whose
 * answer was lost is there twice then, with the same number.
 */
export class JatosSink extends KeptSink {
  private constructor(
    private readonly jatos: Jatos,
    keeping: Keeping,
    kept: Kept,
  ) {
    super(keeping, kept, (session) => async (part) => {
      await jatos.appendResultData(message(keeping.study, session, part) + '\n');
    });
  }

  /** Opens the sink of a run; jatos.onLoad must have called back. */
  static async open(jatos: Jatos, keeping: Omit<Keeping, 'participant'>): Promise<JatosSink> {
    // A run that was begun anew has results of its own: it takes up nothing of another.
    const run = { ...keeping, participant: `JATOS ${jatos.studyResultId}` };
    return new JatosSink(jatos, run, await keep(run));
  }

  /**
   * Returns the session's place in a plan, from 1 to so many, or undefined if all are taken. The batch session counts
   * them (next) and has those that the lab gave back (free); JATOS refuses a change by one who has not seen the last.
   */
  async slot(slots: number): Promise<number | undefined> {
    for (let attempt = 0; this.slotOfSession === undefined; attempt++) {
      const free = this.jatos.batchSession.get('free');
      const next = this.jatos.batchSession.get('next') ?? 1;
      const back: unknown[] = Array.isArray(free) ? free : [];
      const slot = back.length > 0 ? back[0] : next;
      if (typeof slot !== 'number' || slot > slots) {
        return undefined;
      }
      try {
        await (back.length > 0
          ? this.jatos.batchSession.set('free', back.slice(1))
          : this.jatos.batchSession.set('next', slot + 1));
        this.remember({ slot });
      } catch (e) {
        if (attempt + 1 >= ATTEMPTS) {
          throw e;
        }
        await new Promise((resolve) => setTimeout(resolve, Math.random() * (this.keeping.pauses?.first ?? 1000)));
      }
    }
    return this.slotOfSession;
  }

  protected override async arrived(): Promise<void> {
    // endStudy would show a page of JATOS in place of ours, which thanks and leads on.
    await (this.jatos.endStudyWithoutRedirect?.(true) ?? this.jatos.endStudyAjax?.(true));
  }
}
