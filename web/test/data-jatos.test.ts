import { IDBFactory } from 'fake-indexeddb';
import 'fake-indexeddb/auto';
import { describe, expect, it } from 'vitest';
import { JatosSink, type Jatos } from '../src/data/jatos-sink.js';
import type { Waiting } from '../src/data/sink.js';

const PATIENT: Waiting = { begin: () => new Promise(() => undefined), trouble: () => undefined, end: () => undefined };

/** The server of a batch, as the reference of jatos.js describes it: JATOS itself is no package that a test can run. */
class Batch {
  data: Record<string, unknown> = {};
  version = 0;
  readonly results = new Map<string, string>();
  readonly ended: string[] = [];
  lost = 0;

  /** Returns jatos.js in the page of a run: it has a copy of the batch session, and learns of changes later. */
  run(id: string, ending = 'endStudyWithoutRedirect'): Jatos {
    let seen = { ...this.data };
    let version = this.version;
    return {
      studyResultId: id,
      appendResultData: async (text) => {
        await later();
        this.results.set(id, (this.results.get(id) ?? '') + text);
        if (this.lost-- > 0) {
          throw new Error('timeout');
        }
      },
      onLoad: (ready) => { ready(); },
      [ending]: async (successful: boolean) => {
        await later();
        this.ended.push(`${id} ${String(successful)}`);
      },
      batchSession: {
        get: (name) => seen[name],
        set: async (name, value) => {
          const sent = version;
          await later();
          const current = sent === this.version;
          if (current) {
            this.data = { ...this.data, [name]: value };
            this.version++;
          }
          seen = { ...this.data };
          version = this.version;
          if (!current) {
            throw new Error('another changed the batch session');
          }
        },
      },
    };
  }
}

function later(): Promise<void> {
  return new Promise((resolve) => setImmediate(resolve));
}

function keeping() {
  return { study: 'Kitchen', waiting: PATIENT, indexedDB: new IDBFactory(), pauses: { first: 2, longest: 20 } };
}

describe('a sink by JATOS', () => {
  it('adds a line for each part to the result data, and ends the study when all is there', async () => {
    const batch = new Batch();
    const sink = await JatosSink.open(batch.run('7'), keeping());
    batch.lost = 1;
    sink.send({ step: 1 });
    sink.send({ step: 2 });
    await sink.finish();
    const lines = (batch.results.get('7') ?? '').trimEnd().split('\n');
    const parts = lines.map((line) => JSON.parse(line) as { part: number; final: boolean; records: unknown[] });
    const once = new Map(parts.map((part) => [part.part, part]));
    expect(once.size).toBe(parts.length - 1); // the part whose answer was lost is there twice
    expect([...once.values()].flatMap((part) => part.records)).toEqual([{ step: 1 }, { step: 2 }]);
    expect(parts.at(-1)).toMatchObject({ study: 'Kitchen', session: sink.session, final: true });
    expect(batch.ended).toEqual(['7 true']);
  });

  it('ends the study in JATOS before 3.9.7, too', async () => {
    const batch = new Batch();
    const sink = await JatosSink.open(batch.run('3', 'endStudyAjax'), keeping());
    await sink.finish();
    expect(batch.ended).toEqual(['3 true']);
  });

  it('takes each place once, those first that were given back', async () => {
    const batch = new Batch();
    batch.data = { next: 3, free: [1] };
    const sinks = await Promise.all(['1', '2', '3', '4', '5'].map((id) => JatosSink.open(batch.run(id), keeping())));
    const places = await Promise.all(sinks.map((sink) => sink.slot(5)));
    expect(places.sort()).toEqual([1, 3, 4, 5, undefined]);
    expect(batch.data).toEqual({ next: 6, free: [] });
    for (const sink of sinks) {
      sink.close();
    }
  });

  it('keeps the place that a run has', async () => {
    const sink = await JatosSink.open(new Batch().run('1'), keeping());
    expect(await sink.slot(2)).toBe(1);
    expect(await sink.slot(2)).toBe(1);
    sink.close();
  });
});
