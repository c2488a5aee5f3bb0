import type { Headset } from '../../scene/headset.js';
import type { Pose } from '../../scene/pose.js';
import type { World } from '../../scene/world.js';
import type { XrInputEvent } from '../../scene/webxr.js';
import type { FieldNode } from '../../scene/xite.js';
import { meets } from './ray.js';
import { HEIGHT, Sheet, WIDTH } from './sheet.js';

/** How far below the scene the floor of the room is, in metres: farther than any scene is seen. */
const BELOW = -500;

/** Metres from the eyes to the panel, and its width. */
const AWAY = 1.6;
const WIDE = 1.6;

/** Metres from the middle of the room to its grey wall. */
const WALL = 8;

/** The sizes that letters are tried in until a sheet is not too full. */
const SCALES = [1, 0.85, 0.7, 0.58, 0.48];

/**
 * A room below a scene, with a panel before the eyes: what participants see in a headset between exposures. It is in the
 * scene's own world, so that coming and going loads nothing. A black ball about the head is the curtain of exposures.
 */
export class HeadsetRoom {
  /** The sheet that is shown. */
  sheet: Sheet | undefined;

  private readonly canvas = document.createElement('canvas');
  private readonly panel: FieldNode;
  private readonly place: FieldNode;
  private readonly texture: FieldNode;
  private readonly ball: FieldNode;
  private readonly black: FieldNode;
  private middle: Pose = { x: 0, y: 0, z: 0, yaw: 0, pitch: 0, roll: 0 };
  private back: Pose | undefined;

  constructor(
    private readonly world: World,
    private readonly headset: Headset,
  ) {
    this.canvas.width = WIDTH;
    this.canvas.height = HEIGHT;
    const { x3d } = world;
    this.texture = world.node('ImageTexture', {});
    this.place = world.node('Transform', {});
    this.place.children = new x3d.MFNode(world.node('Shape', {
      geometry: world.node('Rectangle2D', { size: new x3d.SFVec2f(WIDE, (WIDE * HEIGHT) / WIDTH) }),
      appearance: world.node('Appearance', { texture: this.texture }), // without a material no light falls on it
    }));
    this.panel = world.node('Switch', { whichChoice: -1, children: new x3d.MFNode(this.place) });
    const wall = world.node('Transform', { translation: new x3d.SFVec3f(0, BELOW, 0) });
    wall.children = new x3d.MFNode(ball(world, WALL, glow(world, 0.16, 0.17, 0.19)));
    world.add(wall);
    world.add(this.panel);

    this.black = glow(world, 0, 0, 0);
    const about = world.node('Transform', {});
    // Farther than the near plane of the eyes, which X_ITE has at half the walker's radius, also aslant.
    about.children = new x3d.MFNode(ball(world, 1.1 * world.walker().radius, this.black));
    this.ball = world.node('Switch', { whichChoice: -1, children: new x3d.MFNode(about) });
    world.add(this.ball);
    world.carry(about);
  }

  /** Takes the viewer into the room. */
  enter(): void {
    if (!this.back) {
      const pose = this.world.pose();
      this.back = { ...pose, y: pose.y - this.headset.head().y };
    }
    this.ball.whichChoice = -1;
    this.headset.rays = true;
    this.centre();
  }

  /** Takes the viewer back to where the scene was left, in the dark. */
  leave(): void {
    this.curtain(0);
    this.panel.whichChoice = -1;
    this.headset.rays = false;
    this.sheet = undefined;
    if (this.back) {
      this.world.setPose({ ...this.back, y: this.back.y + this.headset.head().y });
      this.back = undefined;
    }
  }

  /** Darkens the scene; 1 is its own brightness. */
  curtain(brightness: number): void {
    this.black.transparency = brightness;
    this.ball.whichChoice = brightness < 1 ? 0 : -1;
  }

  /** Shows a sheet on the panel, before the eyes if none was there. */
  show(fill: (sheet: Sheet) => void, pictures: ReadonlyMap<string, HTMLImageElement> = new Map()): void {
    const context = this.canvas.getContext('2d');
    if (!context) {
      throw new Error('the browser has no memory left for the panel');
    }
    for (const scale of SCALES) {
      this.sheet = new Sheet(context, scale, pictures);
      fill(this.sheet);
      if (this.sheet.fits) {
        break;
      }
    }
    this.texture.url = new this.world.x3d.MFString(this.canvas.toDataURL());
    if (Number(this.panel.whichChoice) !== 0) {
      this.centre();
      this.panel.whichChoice = 0;
    }
  }

  /** Takes the panel away. */
  clear(): void {
    this.sheet = undefined;
    this.panel.whichChoice = -1;
  }

  /** Presses what a controller, hand or gaze points at. */
  pressed(event: XrInputEvent): void {
    const { origin } = this.headset;
    const pose = origin && event.frame.getPose(event.inputSource.targetRaySpace, origin);
    const point = pose && meets(pose.transform, this.middle, WIDE, (WIDE * HEIGHT) / WIDTH);
    if (point) {
      this.press(point.u * WIDTH, point.v * HEIGHT);
    }
  }

  private press(x: number, y: number): void {
    const target = this.sheet?.targets.find((each) =>
      x >= each.x && x <= each.x + each.width && y >= each.y && y <= each.y + each.height);
    target?.pressed((x - target.x) / target.width);
  }

  /** Puts the viewer into the middle of the room, and the panel before the eyes. */
  private centre(): void {
    const head = this.headset.head();
    const yaw = (head.yaw * Math.PI) / 180;
    this.middle = { ...head, x: head.x - AWAY * Math.sin(yaw), z: head.z - AWAY * Math.cos(yaw), pitch: 0, roll: 0 };
    this.world.setPose({ ...head, x: 0, y: BELOW + head.y, z: 0, yaw: 0 });
    this.place.translation = new this.world.x3d.SFVec3f(0, BELOW + head.y, -AWAY);
  }
}

/** Makes a ball that is seen from within. */
function ball(world: World, radius: number, material: FieldNode): FieldNode {
  return world.node('Shape', {
    geometry: world.node('Sphere', { radius, solid: false }),
    appearance: world.node('Appearance', { material }),
  });
}

/** Makes a material of one colour, whatever light falls on it; an UnlitMaterial is in X3D 4 only. */
function glow(world: World, red: number, green: number, blue: number): FieldNode {
  const { x3d } = world;
  const none = new x3d.SFColor(0, 0, 0);
  return world.node('Material', {
    ambientIntensity: 0,
    diffuseColor: none,
    specularColor: none,
    emissiveColor: new x3d.SFColor(red, green, blue),
  });
}
