import { expect, it } from 'vitest';
import { Outbox } from '../src/data/outbox.js';
import { MemoryStore, type Part } from '../src/data/store.js';

it('an outbox sends a record that comes while it finds that there is none', async () => {
  const sent: string[] = [];
  const outbox: Outbox = new Outbox(
    new (class extends MemoryStore {
      private late = true;

      override async next(): Promise<Part | undefined> {
        const part = await super.next();
        if (part === undefined && this.late) {
          this.late = false;
          outbox.add(2);
          await new Promise((resolve) => setImmediate(resolve)); // it is saved meanwhile
        }
        return part;
      }
    })(),
    (part) => {
      sent.push(...part.records);
      return Promise.resolve();
    },
  );
  outbox.add(1);
  for (let i = 0; i < 20; i++) {
    await new Promise((resolve) => setImmediate(resolve));
  }
  expect(sent).toEqual(['1', '2']);
});
