import type { FieldNode } from './xite.js';

/** A scene does not load this version of an object at once; LaterVersions.java writes it. */
export interface LaterVersion {
  /** DEF name of the object's Switch. */
  readonly object: string;
  /** The place of the version in the Switch. */
  readonly choice: number;
  /** DEF names of the version's Inlines. */
  readonly inlines: readonly string[];
  /** The files that the Inlines name, relative to the scene's. */
  readonly files: readonly string[];
}

/** Versions are loaded by this. */
export interface Loader {
  /** Returns a node of the scene. */
  named(name: string): FieldNode;
  /** Returns the choice that an object shows. */
  choice(object: string): number;
  /** Waits until Inlines have their content, or none is to be had. */
  loaded(inlines: readonly FieldNode[]): Promise<void>;
}

/** Holds the versions of a scene that are not loaded yet. */
export class LaterVersions {
  private readonly left: Set<LaterVersion>;

  constructor(
    versions: readonly LaterVersion[],
    private readonly loader: Loader,
  ) {
    this.left = new Set(versions);
  }

  /** Loads the versions that are shown; returns when they are there. */
  async loadShown(): Promise<void> {
    const shown = [...this.left].filter(({ object, choice }) => this.loader.choice(object) === choice);
    await Promise.all(shown.map((version) => this.load(version)));
  }

  /** Loads the version that an object has begun to show, unless it is there. */
  show(object: string, choice: number): void {
    for (const version of this.left) {
      if (version.object === object && version.choice === choice) {
        void this.load(version);
      }
    }
  }

  /** Loads one more version; returns false when all are there. */
  async loadNext(): Promise<boolean> {
    const [next] = this.left;
    if (!next) {
      return false;
    }
    await this.load(next);
    return true;
  }

  private async load(version: LaterVersion): Promise<void> {
    this.left.delete(version);
    const inlines = version.inlines.map((name) => this.loader.named(name));
    inlines.forEach((inline) => { inline.load = true; });
    await this.loader.loaded(inlines);
  }
}
