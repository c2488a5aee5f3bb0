import type X3D from 'x_ite/x_ite.d.ts';
import { copyArraysFast, type GeometryArray } from './geometry-arrays.js';
import { readNumbersFast, type ValueParser } from './numbers.js';

/** The X3D browser X_ITE; nextFrame is documented at its pages, but not in its type declarations. */
export type Browser = X3D.X3DBrowser & { nextFrame(): Promise<void> };
export type Namespace = typeof X3D;
export type Scene = X3D.X3DScene;
export type Node = X3D.SFNode;

/** X_ITE prepares this of a model for the graphics card. */
interface Geometry {
  generateTangents: (this: Geometry) => void;
}

/** X_ITE's own components ask for parts of it by these names. */
interface Internals {
  require(name: 'VRMLParser'): { prototype: ValueParser } | undefined;
  require(name: 'X3DGeometryNode'): { createArray(): GeometryArray; prototype: Geometry } | undefined;
}

/** A node whose fields are set and read by name. */
export type FieldNode = Node & Record<string, unknown>;

/** Returns X_ITE, which the page has loaded as a script, so that it finds its components beside that. */
export function xite(): Namespace {
  const loaded = (globalThis as { X3D?: Namespace }).X3D;
  if (!loaded) {
    throw new Error('X_ITE has not been loaded: the page lacks its file x_ite.min.js');
  }
  quicken(loaded as Namespace & Internals);
  return loaded;
}

const quick = new WeakSet();

/** Takes what is slow in the version of X_ITE that is pinned out of the way of large models, once. */
function quicken(x3d: Internals): void {
  if (quick.has(x3d)) {
    return;
  }
  quick.add(x3d);
  const parser = x3d.require('VRMLParser');
  if (parser) {
    readNumbersFast(parser.prototype);
  }
  const geometry = x3d.require('X3DGeometryNode');
  if (geometry) {
    copyArraysFast(geometry.createArray());
  }
}

/** Returns X_ITE's browser of its element. */
export function browserOf(canvas: HTMLElement): Browser {
  return xite().getBrowser(canvas as never) as unknown as Browser;
}

/** Returns a node of a scene by its DEF name. */
export function named(scene: Scene, name: string): FieldNode {
  return scene.getNamedNode(name) as FieldNode;
}

/** Returns whether two of X_ITE's objects stand for the same node. */
export function same(one: object, other: object): boolean {
  return one === other || (one as { equals?: (node: unknown) => boolean }).equals?.(other) === true;
}

/** A viewpoint as X_ITE has it inside, with what its own viewers have moved it by. */
interface Viewed {
  readonly _positionOffset: { readonly x: number; readonly y: number; readonly z: number };
  resetUserOffsets(): void;
}

/** Takes back what X_ITE's own viewers have moved a viewpoint by, such as up a step; returns whether there was any. */
export function takeBackOffset(viewpoint: FieldNode): boolean {
  const viewed = (viewpoint as unknown as { getValue(): Viewed }).getValue();
  const { x, y, z } = viewed._positionOffset;
  if (x === 0 && y === 0 && z === 0) {
    return false;
  }
  viewed.resetUserOffsets();
  return true;
}

const generators = new WeakMap<Geometry, Geometry['generateTangents']>();

/** Lets X_ITE compute the tangents of the models that it loads from now on, or leave that, as only some scenes need them. */
export function prepareTangents(needed: boolean): void {
  const geometry = (xite() as Namespace & Internals).require('X3DGeometryNode')?.prototype;
  if (geometry) {
    const generate = generators.get(geometry) ?? geometry.generateTangents;
    generators.set(geometry, generate);
    geometry.generateTangents = needed ? generate : (): void => undefined;
  }
}
