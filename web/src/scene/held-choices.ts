import { same, type FieldNode } from './xite.js';

/** A scene in which Switches are held. */
export interface SwitchScene {
  /** Returns a node by its DEF name, or throws. */
  named(name: string): FieldNode;
  /** The ROUTEs of the scene. */
  readonly routes: Iterable<Route>;
}

/** What a ROUTE connects. */
export interface Route {
  readonly sourceNode: object;
  readonly sourceField: string;
  readonly destinationNode: object;
  readonly destinationField: string;
}

/** ROUTEs name the field of a Switch so; X_ITE the second way. */
const CHOICE = ['whichChoice', 'set_whichChoice'];

interface Source {
  readonly node: FieldNode;
  readonly field: string;
}

/** A Switch whose choice is held, and the choice that the scene wants meanwhile. */
interface Held {
  readonly node: FieldNode;
  /** Those whose ROUTEs set the Switch. */
  readonly sources: readonly Source[];
  choice: number;
  wanted: number;
}

/** The choices of Switches that a page sets: nothing else changes them until they are released. */
export class HeldChoices {
  private readonly held = new Map<string, Held>();

  constructor(private readonly scene: SwitchScene) {}

  /**
   * Sets the choice of a Switch.
   *
   * @throws Error with a sentence if the scene has no such Switch
   */
  hold(name: string, choice: number): void {
    const held = this.held.get(name) ?? this.watched(name);
    held.choice = choice;
    if (Number(held.node.whichChoice) !== choice) {
      held.node.whichChoice = choice;
    }
  }

  /** Lets all Switches show again what the scene wants. */
  release(): void {
    for (const held of this.held.values()) {
      held.node.removeFieldCallback(this, 'whichChoice');
      held.sources.forEach(({ node, field }) => { node.removeFieldCallback(held, field); });
      held.node.whichChoice = held.wanted;
    }
    this.held.clear();
  }

  private watched(name: string): Held {
    let node: FieldNode;
    try {
      node = this.scene.named(name);
    } catch (error) {
      throw new Error(`the scene has no Switch ${name}; export the study anew`, { cause: error });
    }
    const choice = Number(node.whichChoice);
    const held: Held = { node, sources: this.sources(node), choice, wanted: choice };
    this.held.set(name, held);
    node.addFieldCallback(this, 'whichChoice', (value) => {
      if (Number(value) !== held.choice) {
        held.wanted = Number(value);
        node.whichChoice = held.choice;
      }
    });
    // The Switch does not tell a choice that the scene sends from the same one that is held.
    held.sources.forEach((source) => {
      source.node.addFieldCallback(held, source.field, (value) => { held.wanted = Number(value); });
    });
    return held;
  }

  private sources(node: FieldNode): Source[] {
    return [...this.scene.routes]
      .filter((route) => CHOICE.includes(route.destinationField) && same(route.destinationNode, node))
      .map((route) => ({ node: route.sourceNode as FieldNode, field: route.sourceField }));
  }
}
