import { keep, KeptSink, message, type Keeping, type Kept } from './sink.js';

/** A receiver of docs/web-data.md. */
export interface Receiver extends Keeping {
  /** Its address, without data or slot. */
  readonly url: string;
  /** Milliseconds for an answer. */
  readonly timeout?: number;
}

const TIMEOUT = 120_000;

/** Bytes of a request that a browser still sends when the tab is closed meanwhile; the standard allows 64 KiB. */
const KEEPALIVE = 60_000;

/** Sends data to a receiver by HTTP. */
export class HttpSink extends KeptSink {
  private constructor(
    private readonly receiver: Receiver,
    kept: Kept,
  ) {
    super(receiver, kept, (session) => async (part) => {
      const answer = await post(receiver, 'data', message(receiver.study, session, part));
      if (answer.received !== part.records.length) {
        throw new Error(`${receiver.url} did not confirm what it received`);
      }
    });
  }

  static async open(receiver: Receiver): Promise<HttpSink> {
    return new HttpSink(receiver, await keep(receiver));
  }

  /**
   * Returns the session's place in the plan of the study, the same each time, or undefined if all are taken; fails if
   * the receiver cannot be asked.
   */
  async slot(): Promise<number | undefined> {
    if (this.slotOfSession === undefined) {
      const { study } = this.receiver;
      const answer = await post(this.receiver, 'slot', JSON.stringify({ study, session: this.session }), 410);
      if (answer.slot === undefined) {
        return undefined;
      }
      this.remember({ slot: answer.slot });
    }
    return this.slotOfSession;
  }
}

interface Answer {
  readonly received?: number;
  readonly slot?: number;
  readonly error?: string;
}

async function post(receiver: Receiver, what: string, body: string, also?: number): Promise<Answer> {
  const answer = await fetch(`${receiver.url.replace(/\/+$/, '')}/${what}`, {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body,
    keepalive: new TextEncoder().encode(body).length <= KEEPALIVE,
    credentials: 'omit',
    cache: 'no-store',
    signal: AbortSignal.timeout(receiver.timeout ?? TIMEOUT),
  });
  const text = await answer.text();
  if (!answer.ok && answer.status !== also) {
    throw new Error(`${receiver.url} answered ${answer.status}: ${text.slice(0, 200)}`);
  }
  return JSON.parse(text) as Answer;
}
