import { readFileSync } from 'node:fs';
import { createContext, Script, type Context } from 'node:vm';
import { describe, expect, it } from 'vitest';

/** The Script that exported scenes carry, and the cases that hold both it and the Java controller to the same rules. */
const EXPORT = new URL('../../modules/export/src/', import.meta.url);
const RULES = readFileSync(
  new URL('main/resources/org/selectiverenderer/export/schema-controller.js', EXPORT),
  'utf8',
);

interface Area {
  enter: string[];
  exit: string[];
}

interface VersionedObject {
  shown: number;
  choices: Record<string, number>;
}

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

/** Runs the Script as an X3D browser does: fields are variables, outputs are assigned to. */
class Controller {
  private readonly context: Context;
  private sent = new Map<number, number>();

  constructor(areas: Area[], objects: VersionedObject[], fields: Record<string, unknown>) {
    const schemas = objects.map((object) => Object.keys(object.choices));
    this.context = createContext({
      condition: 'selective',
      seed: 0,
      enterLengths: areas.map((area) => area.enter.length),
      enterSchemas: areas.flatMap((area) => area.enter),
      exitLengths: areas.map((area) => area.exit.length),
      exitSchemas: areas.flatMap((area) => area.exit),
      choiceLengths: schemas.map((names) => names.length),
      choiceSchemas: schemas.flat(),
      choices: objects.flatMap((object) => Object.values(object.choices)),
      shown: objects.map((object) => object.shown),
      most: [],
      least: [],
      highLow: [],
      send: (object: number, choice: number) => { this.sent.set(object, choice); },
      ...fields,
    });
    new Script(RULES).runInContext(this.context);
    this.call('initialize();');
  }

  /** Calls a function of the Script; returns the choices that it sends by object. */
  call(code: string): Map<number, number> {
    this.sent = new Map();
    new Script(code).runInContext(this.context);
    return this.sent;
  }
}

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
