import { readFileSync } from 'node:fs';
import { createContext, Script, type Context } from 'node:vm';

/** The Script that exported scenes carry, and the cases that hold both it and the Java controller to the same rules. */
export const EXPORT = new URL('../../modules/export/src/', import.meta.url);
const RULES = readFileSync(
  new URL('main/resources/org/selectiverenderer/export/schema-controller.js', EXPORT),
  'utf8',
);

export interface Area {
  enter: string[];
  exit: string[];
}

export interface VersionedObject {
  shown: number;
  choices: Record<string, number>;
}

/** Runs the Script as an X3D browser does: fields are variables, outputs are assigned to. */
export class Controller {
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
      lotLengths: [objects.length],
      lotMembers: objects.map((_, number) => number),
      lotSeeds: [0],
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
