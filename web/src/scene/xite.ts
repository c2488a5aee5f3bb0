import type X3D from 'x_ite/x_ite.d.ts';

/** The X3D browser X_ITE; nextFrame is documented at its pages, but not in its type declarations. */
export type Browser = X3D.X3DBrowser & { nextFrame(): Promise<void> };
export type Namespace = typeof X3D;
export type Scene = X3D.X3DScene;
export type Node = X3D.SFNode;

/** A node whose fields are set and read by name. */
export type FieldNode = Node & Record<string, unknown>;

/** Returns X_ITE, which the page has loaded as a script, so that it finds its components beside that. */
export function xite(): Namespace {
  const loaded = (globalThis as { X3D?: Namespace }).X3D;
  if (!loaded) {
    throw new Error('X_ITE has not been loaded: the page lacks its file x_ite.min.js');
  }
  return loaded;
}

/** Returns X_ITE's browser of its element. */
export function browserOf(canvas: HTMLElement): Browser {
  return xite().getBrowser(canvas as never) as unknown as Browser;
}

/** Returns a node of a scene by its DEF name. */
export function named(scene: Scene, name: string): FieldNode {
  return scene.getNamedNode(name) as FieldNode;
}
