import { IDBFactory } from 'fake-indexeddb';
import 'fake-indexeddb/auto';
import { describe, expect, it } from 'vitest';
import { IndexedStore } from '../src/data/indexed-store.js';
import { MemoryStore, type Store } from '../src/data/store.js';

const SESSION = '7c0e2a52-5d0b-4c12-9d3e-000000000001';

describe.each<[string, () => Promise<Store>]>([
  ['memory', () => Promise.resolve(new MemoryStore())],
  ['IndexedDB', () => IndexedStore.open(new IDBFactory(), SESSION)],
])('data in %s', (_, open) => {
  it('go out in parts that never change, the oldest first', async () => {
    const store = await open();
    expect(await store.next()).toBeUndefined();
    await store.add('1');
    await store.add('2');
    expect(await store.next()).toMatchObject({ part: 0, final: false, records: ['1', '2'] });
    await store.add('3');
    expect(await store.next()).toMatchObject({ part: 0, final: false, records: ['1', '2'] });
    expect(await store.left()).toEqual(['1', '2', '3']);
    await store.answered(0);
    await store.answered(0);
    expect(await store.next()).toMatchObject({ part: 1, records: ['3'] });
    await store.answered(1);
    expect(await store.left()).toEqual([]);
  });

  it('end with one final part, with the last records or with none', async () => {
    const store = await open();
    await store.add('1');
    await store.end();
    await store.end();
    expect(await store.next()).toMatchObject({ part: 0, final: true, records: ['1'] });
    await store.answered(0);
    expect(await store.next()).toBeUndefined();

    const empty = await open();
    await empty.end();
    expect(await empty.next()).toMatchObject({ part: 0, final: true, records: [] });
  });

  it('fill parts of bounded size, in which a long record is alone', async () => {
    const store = await open();
    const long = JSON.stringify('α'.repeat(600_000)); // 1.2 MB
    const half = JSON.stringify('x'.repeat(600_000));
    for (const record of [half, half, long, '1']) {
      await store.add(record);
    }
    await store.end();
    const parts: (readonly string[])[] = [];
    for (let part = await store.next(); part !== undefined; part = await store.next()) {
      parts.push(part.records);
      expect(part.final).toBe(parts.length === 4);
      await store.answered(part.part);
    }
    expect(parts).toEqual([[half], [half], [long], ['1']]);
  });
});

describe('data in IndexedDB', () => {
  it('are there again in another page, apart from those of other sessions', async () => {
    const browser = new IDBFactory();
    const before = await IndexedStore.open(browser, SESSION);
    await before.add('1');
    await before.next();
    await before.add('2');
    await before.end();
    before.close();

    const other = await IndexedStore.open(browser, SESSION.replace('1', '2'));
    expect(await other.next()).toBeUndefined();
    const after = await IndexedStore.open(browser, SESSION);
    expect(await after.left()).toEqual(['1', '2']);
    expect(await after.next()).toMatchObject({ part: 0, final: false, records: ['1'] });
    await after.answered(0);
    expect(await after.next()).toMatchObject({ part: 1, final: true, records: ['2'] });
  });

  it('of two tabs with one session never give a number to different parts', async () => {
    const browser = new IDBFactory();
    const tabs = [await IndexedStore.open(browser, SESSION), await IndexedStore.open(browser, SESSION)];
    const sent = new Map<number, readonly string[]>();
    await Promise.all(
      tabs.map(async (tab, i) => {
        for (let n = 0; n < 20; n++) {
          await tab.add(JSON.stringify([i, n]));
          const part = await tab.next();
          if (part !== undefined) {
            expect(sent.get(part.part) ?? part.records).toEqual(part.records);
            sent.set(part.part, part.records);
            await tab.answered(part.part);
          }
        }
      }),
    );
    for (let part = await tabs[0]?.next(); part !== undefined; part = await tabs[0]?.next()) {
      sent.set(part.part, part.records);
      await tabs[0]?.answered(part.part);
    }
    const records = [...sent.values()].flat();
    expect(records).toHaveLength(40);
    expect(new Set(records).size).toBe(40);
  });
});
