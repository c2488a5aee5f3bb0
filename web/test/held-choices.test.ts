import { describe, expect, it } from 'vitest';
import { HeldChoices, type Route } from '../src/scene/held-choices.js';
import type { FieldNode } from '../src/scene/xite.js';
import { Controller } from './schema-script.js';

/** A node of X_ITE as far as ROUTEs go: what is set is an event, which counts with the next frame. */
class RoutedNode {
  private readonly callbacks = new Map<string, Map<unknown, (value: unknown) => void>>();

  constructor(private readonly scene: RoutedScene, private choice: number) {}

  get whichChoice(): number {
    return this.choice;
  }

  set whichChoice(choice: number) {
    this.send('whichChoice', choice);
  }

  send(field: string, choice: number): void {
    this.choice = choice;
    this.scene.events.push(() => { this.process(field, choice); });
  }

  addFieldCallback(key: unknown, field: string, callback: (value: unknown) => void): void {
    this.callbacks.set(field, new Map(this.callbacks.get(field)).set(key, callback));
  }

  removeFieldCallback(key: unknown, field: string): void {
    this.callbacks.get(field)?.delete(key);
  }

  /** How many callbacks a field has. */
  watchers(field: string): number {
    return this.callbacks.get(field)?.size ?? 0;
  }

  private process(field: string, choice: number): void {
    this.scene.routes.filter((route) => route.sourceNode === this && route.sourceField === field)
      .forEach((route) => { (route.destinationNode as RoutedNode).send(route.destinationField.replace('set_', ''), choice); });
    this.callbacks.get(field)?.forEach((callback) => { callback(choice); });
  }
}

/** A scene of one Switch, which the file shows as 0 and which has the choice 2 in the condition high; and of a trigger. */
class RoutedScene {
  readonly events: (() => void)[] = [];
  readonly lamp = new RoutedNode(this, 0);
  readonly script = new RoutedNode(this, 0);
  readonly trigger = new RoutedNode(this, 0);
  readonly routes: Route[] = [
    { sourceNode: this.script, sourceField: 'choice0', destinationNode: this.lamp, destinationField: 'set_whichChoice' },
    { sourceNode: this.trigger, sourceField: 'triggerValue', destinationNode: this.lamp, destinationField: 'set_whichChoice' },
  ];
  readonly choices = new HeldChoices({ named: (name) => this.named(name), routes: this.routes });
  private readonly rules = new Controller([], [{ shown: 0, choices: { desk: 1 } }], { most: [2], least: [1], highLow: [1] });

  setCondition(condition: string): void {
    this.events.push(() => {
      this.rules.call(`setCondition('${condition}');`).forEach((choice) => { this.script.send('choice0', choice); });
    });
  }

  /** Handles all events, and what they lead to. */
  frame(): void {
    for (let event = this.events.shift(); event; event = this.events.shift()) {
      event();
    }
  }

  private named(name: string): FieldNode {
    if (name !== 'Lamp') {
      throw new Error('unknown node');
    }
    return this.lamp as unknown as FieldNode;
  }
}

describe('choices that are held', () => {
  it('are what the Script wants after a trial that held just that', () => {
    const scene = new RoutedScene();
    scene.setCondition('high');
    scene.choices.hold('Lamp', 2);
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(2);
    scene.choices.release();
    scene.frame();
    scene.setCondition('high');
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(2);
  });

  it('are what the scene wants after a ROUTE sent just what was held, or another choice', () => {
    const scene = new RoutedScene();
    scene.choices.hold('Lamp', 2);
    scene.frame();
    for (const choice of [2, 1, 2]) {
      scene.trigger.send('triggerValue', choice);
      scene.frame();
      expect(scene.lamp.whichChoice).toBe(2);
    }
    scene.choices.release();
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(2);
  });

  it('change back to what the scene last wanted, whatever was held in between', () => {
    const scene = new RoutedScene();
    scene.choices.hold('Lamp', 1);
    scene.setCondition('high-low');
    scene.frame();
    scene.choices.hold('Lamp', -1);
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(-1);
    scene.setCondition('high');
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(-1);
    scene.choices.release();
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(2);
  });

  it('are watched until they are released only', () => {
    const scene = new RoutedScene();
    scene.choices.hold('Lamp', 1);
    scene.choices.release();
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(0);
    expect([scene.lamp.watchers('whichChoice'), scene.script.watchers('choice0')]).toEqual([0, 0]);
    scene.setCondition('high');
    scene.frame();
    expect(scene.lamp.whichChoice).toBe(2);
  });

  it('are of Switches that the scene has', () => {
    expect(() => { new RoutedScene().choices.hold('Lost', 1); }).toThrow('the scene has no Switch Lost; export the study anew');
  });
});
