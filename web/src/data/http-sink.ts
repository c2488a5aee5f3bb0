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
   * Returns the session's place in the plan of the study, from 1, the same each time, or undefined if all are taken;
   * fails if the receiver cannot be asked.
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
  const answer = await asked(`${receiver.url.replace(/\/+$/, '')}/${what}`, {
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
    throw new Error(refusal(receiver, answer.status, text));
  }
  return JSON.parse(text) as Answer;
}

/** As fetch; what keeps a browser from an answer is said in a sentence. */
async function asked(url: string, request: RequestInit): Promise<Response> {
  try {
    return await fetch(url, request);
  } catch (error) {
    const origin = typeof location === 'undefined' ? 'this page' : location.origin;
    throw new Error(
      `${url} does not answer. Researchers: does the receiver run there, and does it allow this page (--origin ${origin})?`,
      { cause: error },
    );
  }
}

/** Returns what a refusal means for those who set the study up. */
function refusal({ url, study }: Receiver, status: number, text: string): string {
  switch (status) {
    case 403:
      return `${url} does not allow this page. Researchers: start the receiver with the page's --origin.`;
    case 404:
      return `${url} does not receive the study "${study}". Researchers: start the receiver with --study "${study}", `
        + 'or correct "receiver" in study-settings.json.';
    default:
      return `${url} answered ${status}: ${text.slice(0, 200)}`;
  }
}
