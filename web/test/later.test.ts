import { describe, expect, it } from 'vitest';
import { LaterVersions, type LaterVersion } from '../src/scene/later.js';
import type { FieldNode } from '../src/scene/xite.js';

const CUP: LaterVersion = { object: 'Switch_Cup', choice: 0, inlines: ['Cup', 'Saucer'], files: ['cup.x3dz'] };
const LAMP: LaterVersion = { object: 'Switch_Lamp', choice: 0, inlines: ['Lamp'], files: ['lamp.x3dz'] };

/** A scene of nodes without content, in which the objects show choices. */
function scene(choices: Record<string, number>): { later: LaterVersions; loaded: string[] } {
  const loaded: string[] = [];
  const nodes = new Map(['Cup', 'Saucer', 'Lamp'].map((name) => [name, { load: false, name } as unknown as FieldNode]));
  const later = new LaterVersions([CUP, LAMP], {
    named: (name) => nodes.get(name) ?? expect.unreachable(name),
    choice: (object) => choices[object] ?? -1,
    loaded: (inlines) => {
      loaded.push(...inlines.filter((inline) => inline.load === true).map((inline) => String(inline.name)));
      return Promise.resolve();
    },
  });
  return { later, loaded };
}

describe('versions that are loaded later', () => {
  it('are loaded at once where the scene shows them', async () => {
    const { later, loaded } = scene({ Switch_Cup: 1, Switch_Lamp: 0 });
    await later.loadShown();
    expect(loaded).toEqual(['Lamp']);
  });

  it('are loaded when their object begins to show them, once', async () => {
    const { later, loaded } = scene({});
    later.show('Switch_Cup', 1);
    later.show('Switch_Cup', 0);
    later.show('Switch_Cup', 0);
    await Promise.resolve();
    expect(loaded).toEqual(['Cup', 'Saucer']);
  });

  it('follow one after the other', async () => {
    const { later, loaded } = scene({});
    expect(await later.loadNext()).toBe(true);
    expect(loaded).toEqual(['Cup', 'Saucer']);
    expect(await later.loadNext()).toBe(true);
    expect(loaded).toEqual(['Cup', 'Saucer', 'Lamp']);
    expect(await later.loadNext()).toBe(false);
  });
});
