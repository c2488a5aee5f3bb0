import { HeldChoices } from './held-choices.js';
import { angles, orientation, type Pose } from './pose.js';
import { LaterVersions, type LaterVersion } from './later.js';
import { room, type Rig } from './rig.js';
import { browserOf, named, prepareTangents, same, takeBackOffset, type Browser, type FieldNode, type Namespace, type Scene, xite } from './xite.js';

/** The conditions in which a scene can be shown, as of the command run. */
export const CONDITIONS = ['selective', 'high', 'high-low', 'random'] as const;
export type Condition = (typeof CONDITIONS)[number];

/** An entry into an area, an exit, or an object that changes its version. */
export type WorldEvent =
  | { readonly kind: 'enter' | 'exit'; readonly area: string }
  | { readonly kind: 'switch'; readonly object: string; readonly choice: number };

/** Names of what the page needs to know of an exported scene. */
export interface ExportedScene {
  /** The scene's address, relative to the page. */
  readonly file: string;
  /** DEF name of the Script that controls the versions; none in a scene without enriched objects. */
  readonly controller?: string;
  /** The versions that are loaded after the first picture. */
  readonly later?: readonly LaterVersion[];
  /** Whether a model may need tangents, for a normal map; not told by exports of before. */
  readonly normalMaps?: boolean;
}

/** The first picture shows this. */
export interface Beginning {
  readonly condition: Condition;
  readonly seed: number;
}

interface Vector {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** What X_ITE's declarations lack. */
interface Internals {
  getWorld(): { traverse(type: unknown): void };
  /** Returns nothing without a headset. */
  getPose(): unknown;
}
interface TraverseTypes {
  readonly TraverseType: { readonly COLLISION: unknown };
}

/**
 * The part of its pixels in which a scene is drawn while it is loaded: X_ITE draws it again and again, which takes as
 * long as loading where no graphics card helps.
 */
const DRAFT = 0.1;

/** So many frames after a condition is set, or the viewer stands in an area, all objects show their versions. */
const SETTLED = 3;

/** A box about everything, in metres: the sensor in it tells where the viewer is, in a headset too. */
const EVERYWHERE = 1e6;

/** An exported scene that X_ITE shows. */
export class World {
  /** DEF names of the areas' sensors, in the order of the scene. */
  readonly areas: readonly string[];
  /** DEF names of the objects' Switches, in the order of the scene. */
  readonly objects: readonly string[];

  private readonly listeners = new Set<(event: WorldEvent) => void>();
  private readonly inside = new Set<string>();
  private readonly viewpoint: FieldNode;
  private readonly everywhere: FieldNode;
  private readonly internals: Internals;
  private bound: FieldNode | undefined;
  private rig: Rig | undefined;
  private head: Pose;
  private readonly later: LaterVersions;
  private readonly held: HeldChoices;
  /** Whether the scene itself has the headlight on; known once that was changed. */
  private light: boolean | undefined;

  private constructor(
    /** X_ITE's types, of which nodes that are added have their fields. */
    readonly x3d: Namespace,
    readonly browser: Browser,
    private readonly scene: Scene,
    private readonly controller: FieldNode | undefined,
    later: readonly LaterVersion[],
  ) {
    this.later = new LaterVersions(later, {
      named: (name) => named(scene, name),
      choice: (object) => this.choice(object),
      loaded: (inlines) => this.loaded(inlines),
    });
    this.held = new HeldChoices({ named: (name) => named(scene, name), routes: scene.routes });
    this.areas = controller ? strings(controller.areaNames) : [];
    this.objects = controller ? strings(controller.objectNames) : [];
    this.internals = browser as unknown as Internals;
    this.everywhere = scene.createNode('ProximitySensor') as unknown as FieldNode;
    this.viewpoint = scene.createNode('Viewpoint') as unknown as FieldNode;
    scene.addRootNode(this.viewpoint);
    this.head = this.adopt();
    this.watch();
  }

  /**
   * Opens a scene.
   *
   * @param canvas X_ITE's element of the page
   * @param beginning what the first picture shows; else what the scene says
   * @throws Error with a sentence if the scene cannot be read or has no controller
   */
  static async open(canvas: HTMLElement, exported: ExportedScene, beginning?: Beginning): Promise<World> {
    const x3d = xite();
    prepareTangents(exported.normalMaps !== false);
    const browser = browserOf(canvas);
    if ((browser as unknown as Internals).getPose()) {
      return World.loaded(x3d, browser, exported, beginning); // a headset has no picture of fewer pixels
    }
    const scale = browser.getBrowserOption('ContentScale');
    browser.setBrowserOption('ContentScale', DRAFT);
    try {
      return await World.loaded(x3d, browser, exported, beginning);
    } finally {
      browser.setBrowserOption('ContentScale', scale);
      await browser.nextFrame();
    }
  }

  private static async loaded(
    x3d: Namespace,
    browser: Browser,
    exported: ExportedScene,
    beginning: Beginning | undefined,
  ): Promise<World> {
    try {
      await browser.loadURL(new x3d.MFString(exported.file));
    } catch (error) {
      throw new Error(`${exported.file} cannot be loaded: ${reason(error)}`, { cause: error });
    }
    const scene = browser.currentScene;
    let controller: FieldNode | undefined;
    if (exported.controller !== undefined) {
      try {
        controller = named(scene, exported.controller);
      } catch (error) {
        throw new Error(`${exported.file} has no Script ${exported.controller}; export the scene anew`, { cause: error });
      }
    }
    const world = new World(x3d, browser, scene, controller, exported.later ?? []);
    if (beginning) {
      world.setCondition(beginning.condition, beginning.seed);
    }
    for (let frame = 0; frame < SETTLED; frame++) {
      await browser.nextFrame();
    }
    await world.later.loadShown();
    return world;
  }

  /** Loads one more of the versions that nobody has seen yet; returns false when all are there. */
  loadNext(): Promise<boolean> {
    return this.later.loadNext();
  }

  /** Calls a listener with all events from now on; returns what ends that. */
  listen(listener: (event: WorldEvent) => void): () => void {
    this.listeners.add(listener);
    return () => { this.listeners.delete(listener); };
  }

  /** Returns the areas that the viewer is in, in the order of the scene. */
  entered(): string[] {
    return this.areas.filter((area) => this.inside.has(area));
  }

  /** Returns the choice that the Switch of an object shows; -1 for none. */
  choice(object: string): number {
    return Number(named(this.scene, object).whichChoice);
  }

  /** Shows the objects as a condition says; the seed draws those of the condition random. */
  setCondition(condition: Condition, seed: number): void {
    if (this.controller) {
      this.controller.setSeed = seed;
      this.controller.setCondition = condition;
    }
  }

  /**
   * Sets the choices of Switches, which nothing else changes until they are released.
   *
   * @throws Error with a sentence if the scene has no such Switch
   */
  hold(choices: Readonly<Record<string, number>>): void {
    for (const [name, choice] of Object.entries(choices)) {
      this.held.hold(name, choice);
      if (!this.objects.includes(name)) {
        this.tell({ kind: 'switch', object: name, choice });
      }
    }
  }

  /** Lets all Switches show again what the scene wants. */
  release(): void {
    this.held.release();
  }

  /** Switches the viewer's headlight on or off; undefined for what the scene says. */
  headlight(on: boolean | undefined): void {
    const info = this.browser.activeNavigationInfo as unknown as FieldNode | null;
    if (info) {
      this.light ??= info.headlight === true;
      info.headlight = on ?? this.light;
    }
  }

  /** Returns the descriptions of the scene's viewpoints, in its order; the first is the one it begins with. */
  viewpoints(): string[] {
    return this.views().map((view, i) => String(view.description) || `Viewpoint ${i + 1}`);
  }

  /** Takes the viewer to a viewpoint of the scene, by its place in the order. */
  visit(index: number): void {
    const view = this.views()[index];
    if (view) {
      this.go(view);
    }
  }

  /**
   * Takes the viewer to a viewpoint of the scene, by its DEF name.
   *
   * @throws Error with a sentence if there is none
   */
  visitNamed(name: string): void {
    let view: FieldNode;
    try {
      view = named(this.scene, name);
    } catch (error) {
      throw new Error(`the scene has no Viewpoint ${name}; export the study anew`, { cause: error });
    }
    this.go(view);
  }

  private go(view: FieldNode): void {
    this.bound = view;
    this.viewpoint.fieldOfView = view.fieldOfView ?? Math.PI / 4;
    this.setPose(this.upright(poseOf(view)));
  }

  /** Returns the pose of a head whose body stands at a viewpoint: somebody in a headset has the own height. */
  private upright(view: Pose): Pose {
    return this.rig ? { ...view, y: view.y - this.rig.drop + this.rig.head().y } : view;
  }

  /** Has a headset carry the eyes from now on, or nothing; the viewer stays and looks the same way. */
  wear(rig: Rig | undefined): void {
    // A sensor may have told of a headset before it counts; the viewpoint is still where the viewer stood.
    const stood = poseOf(this.viewpoint);
    const eyes = this.rig ? { ...this.head, y: stood.y + this.rig.drop } : stood;
    this.rig = rig;
    this.setPose(this.upright({ ...eyes, pitch: 0, roll: 0 }));
  }

  /** Returns the headset that carries the eyes; undefined for none. */
  get worn(): Rig | undefined {
    return this.rig;
  }

  /** Returns where the viewer's eyes are, and where they look. */
  pose(): Pose {
    return this.head;
  }

  /** Places the viewer; a headset looks as far up and down as it does. */
  setPose(pose: Pose): void {
    this.head = pose;
    const carried = this.rig ? room(pose, this.rig.head()) : pose;
    const turn = orientation(carried);
    this.viewpoint.position = new this.x3d.SFVec3f(carried.x, carried.y, carried.z);
    this.viewpoint.orientation = new this.x3d.SFRotation(turn.x, turn.y, turn.z, turn.angle);
  }

  /** Returns the part of a horizontal way, in metres, that walls and furniture leave open. */
  free(x: number, z: number): { x: number; z: number } {
    const way = this.fromEyes(() => this.browser.constrainTranslation(new this.x3d.SFVec3f(x, 0, z)) as Vector | null);
    return way ? { x: way.x, z: way.z } : { x, z };
  }

  /**
   * Returns the distance from the eyes down to the floor, in metres; undefined where none is near. In a headset the eyes
   * count as high as those of the scene's walker, for it is the body that stands on the floor.
   */
  floor(): number | undefined {
    const below = this.fromEyes(
      () => this.browser.getClosestObject(new this.x3d.SFVec3f(0, -1, 0)) as { distance: number } | null);
    return below && Number.isFinite(below.distance) && below.distance < 2 * this.walker().eyes
      ? below.distance
      : undefined;
  }

  /** Makes a node, which is not in the scene yet. */
  node(type: string, fields: Readonly<Record<string, unknown>>): FieldNode {
    const made = this.scene.createNode(type as 'Group') as unknown as FieldNode;
    Object.assign(made, fields);
    return made;
  }

  /** Puts a node of the page's own into the scene. */
  add(node: FieldNode): void {
    this.scene.addRootNode(node);
  }

  /** Has the head carry a Transform. */
  carry(transform: FieldNode): void {
    this.scene.addRoute(this.everywhere, 'position_changed', transform, 'translation');
  }

  /** Asks X_ITE about what is near; it looks from the viewpoint, which a headset leaves behind. */
  private fromEyes<T>(ask: () => T): T {
    // X_ITE collects what is near only for viewers of its own that collide, and knows what was near once otherwise.
    this.internals.getWorld().traverse((this.x3d as unknown as TraverseTypes).TraverseType.COLLISION);
    if (!this.rig) {
      return ask();
    }
    const carried = this.viewpoint.position as Vector;
    const back = new this.x3d.SFVec3f(carried.x, carried.y, carried.z);
    this.viewpoint.position = new this.x3d.SFVec3f(this.head.x, carried.y + this.rig.drop, this.head.z);
    try {
      return ask();
    } finally {
      this.viewpoint.position = back;
    }
  }

  /** Returns how the scene wants to be walked: metres per second; radius, height of eyes and of the highest step in metres. */
  walker(): { speed: number; radius: number; eyes: number; stairs: number } {
    const info = this.browser.activeNavigationInfo as unknown as FieldNode | null;
    const size = numbers(info?.avatarSize);
    return { speed: Number(info?.speed ?? 1), radius: size[0] ?? 0.25, eyes: size[1] ?? 1.6, stairs: size[2] ?? 0.75 };
  }

  /** Waits for the next frame, and takes over what the scene itself binds. */
  async nextFrame(): Promise<void> {
    await this.browser.nextFrame();
    this.moveAlone();
    const active = this.browser.activeViewpoint as unknown as FieldNode | null;
    if (active && !same(active, this.viewpoint)) {
      this.head = this.adopt();
    }
  }

  /** The page moves the viewer itself: X_ITE, which would do so as well, leaves it alone. */
  private moveAlone(): void {
    const info = this.browser.activeNavigationInfo as unknown as FieldNode | null;
    if (info && strings(info.type).join() !== 'NONE') {
      info.type = new this.x3d.MFString('NONE');
    }
    // It may have set the viewer on the floor before. Sensors add that to the place in which the page puts the viewer.
    if (takeBackOffset(this.viewpoint) && !this.rig) {
      this.head = poseOf(this.viewpoint);
    }
  }

  /** Begins at the viewpoint that the scene has bound, with a viewpoint of the page's own. */
  private adopt(): Pose {
    const active = this.browser.activeViewpoint as unknown as FieldNode | null;
    if (active && !same(active, this.viewpoint)) {
      this.bound = active;
      this.viewpoint.fieldOfView = active.fieldOfView ?? Math.PI / 4;
    }
    const pose = this.upright(this.bound ? poseOf(this.bound) : { x: 0, y: 0, z: 10, yaw: 0, pitch: 0, roll: 0 });
    this.viewpoint.jump = true;
    this.setPose(pose);
    this.viewpoint.set_bind = true;
    this.moveAlone();
    return pose;
  }

  private views(): FieldNode[] {
    const found: FieldNode[] = [];
    for (const node of this.scene.rootNodes as unknown as Iterable<FieldNode | null>) {
      if (node?.getNodeTypeName() === 'Viewpoint' && !same(node, this.viewpoint)) {
        found.push(node);
      }
    }
    return found;
  }

  private watch(): void {
    for (const area of this.areas) {
      named(this.scene, area).addFieldCallback(this, 'isActive', (active) => {
        if (active) {
          this.inside.add(area);
        } else {
          this.inside.delete(area);
        }
        this.tell({ kind: active ? 'enter' : 'exit', area });
      });
    }
    for (const object of this.objects) {
      named(this.scene, object).addFieldCallback(this, 'whichChoice', (choice) => {
        this.later.show(object, Number(choice));
        this.tell({ kind: 'switch', object, choice: Number(choice) });
      });
    }
    const sensor = this.everywhere;
    sensor.size = new this.x3d.SFVec3f(EVERYWHERE, EVERYWHERE, EVERYWHERE);
    this.scene.addRootNode(sensor);
    sensor.addFieldCallback(this, 'position_changed', (value) => {
      const { x, y, z } = value as Vector;
      this.head = { ...this.head, x, y, z };
    });
    sensor.addFieldCallback(this, 'orientation_changed', (value) => {
      this.head = { ...this.head, ...angles(value as Vector & { angle: number }) };
    });
  }

  /** Waits until Inlines have their content; one whose file fails is as good as there. */
  private async loaded(inlines: readonly FieldNode[]): Promise<void> {
    const sensor = this.scene.createNode('LoadSensor') as unknown as FieldNode;
    await new Promise<void>((done) => {
      sensor.addFieldCallback(this, 'isLoaded', (loaded) => {
        if (loaded) {
          done();
        }
      });
      sensor.addFieldCallback(this, 'isActive', (active) => {
        if (!active) {
          done();
        }
      });
      sensor.children = new this.x3d.MFNode(...(inlines as never[]));
    });
    sensor.dispose();
    await this.browser.nextFrame();
  }

  private tell(event: WorldEvent): void {
    for (const listener of this.listeners) {
      listener(event);
    }
  }
}

function poseOf(view: FieldNode): Pose {
  const at = view.position as Vector;
  return { x: at.x, y: at.y, z: at.z, ...angles(view.orientation as Vector & { angle: number }) };
}

function strings(field: unknown): string[] {
  return [...(field as Iterable<unknown>)].map(String);
}

function numbers(field: unknown): number[] {
  return field === undefined ? [] : [...(field as Iterable<unknown>)].map(Number);
}

function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
