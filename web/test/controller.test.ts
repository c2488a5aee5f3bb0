import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { Controller, EXPORT, type Area, type VersionedObject } from './schema-script.js';

type Step = { changes: Record<string, number> } & ({ enter: string } | { exit: string });

interface Case {
  name: string;
  areas: Record<string, Area>;
  objects: Record<string, VersionedObject>;
  steps: Step[];
}

const { cases, draws } = JSON.parse(
  readFileSync(new URL('test/resources/org/selectiverenderer/export/activation-cases.json', EXPORT), 'utf8'),
) as { cases: Case[]; draws: { seed: number; objects: number; few: number[] }[] };

describe('the Script of exported scenes', () => {
  it.each(cases)('$name', ({ areas, objects, steps }) => {
    const names = Object.keys(objects);
    const controller = new Controller(Object.values(areas), Object.values(objects), {});
    for (const step of steps) {
      const [area, enters] = 'enter' in step ? [step.enter, true] : [step.exit, false];
      const sent = controller.call(
        `arrived.push({ area: ${Object.keys(areas).indexOf(area)}, enters: ${String(enters)} }); eventsProcessed();`,
      );
      const changes: Record<string, number> = {};
      sent.forEach((choice, object) => { changes[names[object] ?? ''] = choice; });
      expect(changes, JSON.stringify(step)).toEqual(step.changes);
    }
  });

  it.each(draws)('draws for seed $seed of $objects objects what Java draws', ({ seed, objects, few }) => {
    const all = Array.from({ length: objects }, (): VersionedObject => ({ shown: -1, choices: {} }));
    const controller = new Controller([], all, {
      most: all.map(() => 0),
      least: all.map(() => 1),
      seed,
    });
    const sent = controller.call("setCondition('random');");
    expect([...sent].filter(([, choice]) => choice === 1).map(([object]) => object)).toEqual(few);
  });

  it('takes entries of one time stamp in the order of the areas', () => {
    const controller = new Controller(
      [{ enter: ['S'], exit: [] }, { enter: ['T'], exit: [] }],
      [{ shown: -1, choices: { S: 0, T: 1 } }],
      {},
    );
    const sent = controller.call(
      'arrived.push({ area: 1, enters: true }); arrived.push({ area: 0, enters: true }); eventsProcessed();',
    );
    expect(sent.get(0)).toBe(1);
  });
});
