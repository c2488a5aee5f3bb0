import { IDBFactory } from 'fake-indexeddb';
import 'fake-indexeddb/auto';
import { Window } from 'happy-dom';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { HttpSink, type Receiver } from '../src/data/http-sink.js';
import type { Waiting } from '../src/data/sink.js';
import { Network, type Fate } from './network.js';

interface Sent {
  readonly study: string;
  readonly session: string;
  readonly part: number;
  readonly final: boolean;
  readonly records: readonly unknown[];
}

const PATIENT: Waiting = { begin: () => new Promise(() => undefined), trouble: () => undefined, end: () => undefined };

describe('a sink by HTTP', () => {
  let network: Network;
  let browser: IDBFactory;
  let storage: Storage;
  let stored: Map<string, Sent>;
  let bodies: string[];
  const sinks: HttpSink[] = [];

  beforeEach(async () => {
    browser = new IDBFactory();
    storage = new Window().localStorage;
    stored = new Map();
    bodies = [];
    network = await Network.open((path, body) => {
      const sent = JSON.parse(body) as Sent;
      if (path === '/study/slot') {
        return Promise.resolve({ status: 200, body: '{"slot": 4}' });
      }
      bodies.push(body);
      const key = `${sent.session} ${sent.part}`;
      expect(stored.get(key) ?? sent).toEqual(sent);
      stored.set(key, sent);
      return Promise.resolve({ status: 200, body: JSON.stringify({ received: sent.records.length }) });
    });
  });

  afterEach(async () => {
    sinks.splice(0).forEach((sink) => {
      sink.close();
    });
    await network.close();
  });

  async function open(more: Partial<Receiver> = {}): Promise<HttpSink> {
    const sink = await HttpSink.open({
      url: `${network.url}/study/`,
      study: 'Kitchen "1"',
      participant: '',
      waiting: PATIENT,
      indexedDB: browser,
      localStorage: storage,
      pauses: { first: 2, longest: 20 },
      ...more,
    });
    sinks.push(sink);
    return sink;
  }

  function records(): unknown[] {
    return [...stored.values()].flatMap((sent) => sent.records);
  }

  function fates(...fates: Fate[]): void {
    network.fate = () => fates.shift() ?? 'arrives';
  }

  it('sends records in their order, and a final part', async () => {
    const sink = await open();
    for (let i = 0; i < 50; i++) {
      sink.send({ step: i, text: 'ά"\n' });
    }
    await sink.finish();
    expect(records()).toEqual(Array.from({ length: 50 }, (_, i) => ({ step: i, text: 'ά"\n' })));
    const sent = [...stored.values()];
    expect(sent.map((one) => one.part)).toEqual(sent.map((_, i) => i));
    expect(sent.map((one) => one.final)).toEqual(sent.map((_, i) => i === sent.length - 1));
    expect(sent[0]).toMatchObject({ study: 'Kitchen "1"', session: sink.session });
    expect(() => {
      sink.send(1);
    }).toThrow('after the end');
  });

  it('sends what was recorded while it was sending', async () => {
    const sink = await open();
    for (let i = 0; i < 20; i++) {
      sink.send(i);
      await new Promise((resolve) => setImmediate(resolve));
    }
    while (records().length < 20) {
      await new Promise((resolve) => setImmediate(resolve));
    }
    await sink.finish();
    expect(records()).toEqual(Array.from({ length: 20 }, (_, i) => i));
  });

  it.each<Fate>(['lost', 'answer lost', 'fails', 'slow', 'answered by a portal', 'twice'])(
    'loses and doubles nothing where a request is: %s',
    async (fate) => {
      fates(fate, 'arrives', fate, fate, fate);
      const sink = await open({ timeout: 200 });
      sink.send(1);
      sink.send(2);
      while (!records().includes(2)) {
        await new Promise((resolve) => setImmediate(resolve));
      }
      sink.send(3);
      await sink.finish();
      expect(records()).toEqual([1, 2, 3]);
      if (fate !== 'twice') {
        expect(network.requests).toBeGreaterThan(stored.size);
      }
    },
  );

  it('tells of trouble and of its end, and tries again when the browser is online', async () => {
    const told: (string | undefined)[] = [];
    const events = new EventTarget();
    const waiting: Waiting = {
      ...PATIENT,
      trouble: (trouble) => {
        told.push(trouble);
        if (trouble !== undefined) {
          network.fate = () => 'arrives';
          setImmediate(() => events.dispatchEvent(new Event('online')));
        }
      },
    };
    network.fate = () => 'fails';
    const sink = await open({ waiting, events, pauses: { first: 1e8, longest: 1e8 } });
    sink.send(1);
    await sink.finish();
    expect(told.find((trouble) => trouble !== undefined)).toContain('answered 500: {"error": "no"}');
    expect(told.at(-1)).toBeUndefined();
  });

  it('goes on in a tab that is opened again: same session, same place, what was left is sent', async () => {
    const closed = await open();
    expect(await closed.slot()).toBe(4);
    expect([closed.resumed, closed.ended, closed.lasting]).toEqual([false, false, true]);
    network.fate = () => 'lost';
    closed.send(1);
    while (network.requests < 3) {
      await new Promise((resolve) => setImmediate(resolve));
    }
    closed.send(2);
    await new Promise((resolve) => setImmediate(resolve));
    closed.close();

    network.fate = () => 'arrives';
    const again = await open();
    expect([again.session, again.resumed, again.ended]).toEqual([closed.session, true, false]);
    network.fate = (body) => (body.includes('slot') ? 'lost' : 'arrives');
    expect(await again.slot()).toBe(4);
    again.send(3);
    await again.finish();
    expect(records()).toEqual([1, 2, 3]);

    const next = await open();
    expect(next.session).not.toBe(closed.session);
    expect(next.resumed).toBe(false);
  });

  it('that was closed at the end only waits for the rest', async () => {
    const closed = await open();
    network.fate = () => 'lost';
    closed.send(1);
    void closed.finish();
    while (network.requests < 3) {
      await new Promise((resolve) => setImmediate(resolve));
    }
    closed.close();
    network.fate = () => 'arrives';
    const again = await open();
    expect([again.resumed, again.ended]).toEqual([true, true]);
    await again.finish();
    expect(records()).toEqual([1]);
    expect([...stored.values()].at(-1)?.final).toBe(true);
  });

  it('gives each participant of one browser a session of its own', async () => {
    const one = await open({ participant: 'PROLIFIC 1' });
    const other = await open({ participant: 'PROLIFIC 2' });
    expect(one.session).not.toBe(other.session);
    expect((await open({ participant: 'PROLIFIC 1' })).session).toBe(one.session);
  });

  it('keeps data in memory where the browser keeps none, under a new session each time, and says so', async () => {
    const forbidden = {
      open: () => {
        throw new DOMException('forbidden', 'SecurityError');
      },
    } as unknown as IDBFactory;
    const sink = await open({ indexedDB: forbidden });
    expect(sink.lasting).toBe(false);
    fates('lost', 'answer lost');
    sink.send(1);
    await sink.finish();
    expect(records()).toEqual([1]);
    const begun = await open({ indexedDB: undefined, localStorage: undefined });
    expect((await open({ indexedDB: forbidden })).session).not.toBe(begun.session);
  });

  it('ends without the rest when the participant has saved it, and sends it from the next page', async () => {
    let saved: string[] = [];
    const waiting: Waiting = {
      ...PATIENT,
      begin: async (name, left) => {
        expect(name).toMatch(/^[0-9a-f-]{36}-rest\.jsonl$/);
        while (network.requests < 3) {
          await new Promise((resolve) => setImmediate(resolve));
        }
        saved = await left();
      },
    };
    network.fate = () => 'lost';
    const sink = await open({ waiting });
    sink.send({ a: 1 });
    sink.send(2);
    await sink.finish();
    expect(saved).toEqual(['{"a":1}', '2']);
    sink.close();

    network.fate = () => 'arrives';
    const again = await open();
    expect(again.ended).toBe(true);
    await again.finish();
    expect(records()).toEqual([{ a: 1 }, 2]);
  });
});
