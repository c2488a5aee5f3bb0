import { angles, type Pose } from './pose.js';
import type { Rig } from './rig.js';
import { webxr, type XrFrame, type XrInputSource, type XrSession, type XrSpace, type XrSystem, type XrTransform } from './webxr.js';
import type { Browser } from './xite.js';

/** What X_ITE's component WebXR adds to its browser; its declarations lack it. */
interface XiteHeadset {
  loadComponents(...components: unknown[]): Promise<void>;
  getComponent(name: string): unknown;
  xrAddButton(): void;
  xrStartSession(): Promise<void>;
  xrFrame(frame: XrFrame | undefined): void;
  xrUpdatePointers(): void;
  getPose(): { readonly views: readonly unknown[] } | null;
  getFramebuffers(): readonly unknown[];
  addBrowserEvent(): void;
}

/** What happens in a session, of who listens. */
export interface HeadsetEvents {
  /** Before the first frame of a session: the headset knows where the head is. */
  readonly worn?: () => void;
  /** The session has ended, also by the headset's own button. */
  readonly left?: () => void;
  /** The headset was taken off or put on again. */
  readonly visible?: (visible: boolean) => void;
}

/** A headset of the web browser (WebXR), in which X_ITE shows its scene. */
export class Headset implements Rig {
  drop = 0;
  /** Whether the controllers' rays are drawn, and touch what they meet. */
  rays = true;
  /** The frame that is shown, while its callback runs. */
  frame: XrFrame | undefined;

  private session: XrSession | undefined;
  private space: XrSpace | undefined;
  private viewer: Pose | undefined;
  private readonly listeners = new Set<HeadsetEvents>();

  private constructor(
    private readonly system: XrSystem,
    private readonly browser: Browser & XiteHeadset,
  ) {
    this.guard();
  }

  /** Returns whether the web browser knows a headset. */
  static async known(): Promise<boolean> {
    return await webxr()?.isSessionSupported('immersive-vr').catch(() => false) ?? false;
  }

  /**
   * Returns the headset that the web browser knows; undefined for none.
   *
   * @param canvas X_ITE's element
   */
  static async find(canvas: HTMLElement, shown: Browser): Promise<Headset | undefined> {
    const system = webxr();
    if (!system || !await Headset.known()) {
      return undefined;
    }
    const browser = shown as Browser & XiteHeadset;
    // Loaded before anybody presses: a session begins only within a moment after the press.
    await browser.loadComponents(...['WebXR', 'Geometry2D', 'Geometry3D'].map((name) => browser.getComponent(name)));
    browser.xrAddButton();
    // X_ITE needs its own button, but nobody is to press it: it would begin a session without the workarounds here.
    canvas.shadowRoot?.querySelector('.x_ite-private-xr-button')?.setAttribute('style', 'display: none !important');
    return new Headset(system, browser);
  }

  /** Whether a session shows the scene in the headset. */
  get worn(): boolean {
    return this.session !== undefined && this.viewer !== undefined;
  }

  get inputs(): readonly XrInputSource[] {
    return this.session ? [...this.session.inputSources] : [];
  }

  /** Returns the space that all poses are told in. */
  get origin(): XrSpace | undefined {
    return this.space;
  }

  /** Returns the session, for its events; undefined for none. */
  get events(): EventTarget | undefined {
    return this.session;
  }

  head(): Pose {
    return this.viewer ?? { x: 0, y: 0, z: 0, yaw: 0, pitch: 0, roll: 0 };
  }

  /** Tells a listener of all sessions from now on; returns what ends that. */
  listen(listener: HeadsetEvents): () => void {
    this.listeners.add(listener);
    return () => { this.listeners.delete(listener); };
  }

  /**
   * Begins a session; to be called when somebody presses something. Ends when the head is known.
   *
   * @param eyes how high the eyes of the scene's walker are above the floor, in metres
   * @throws Error if the headset gives no session
   */
  async enter(eyes: number): Promise<void> {
    if (this.session) {
      return;
    }
    await this.start(eyes);
    while (this.waits()) {
      await this.browser.nextFrame();
    }
  }

  private waits(): boolean {
    return this.session !== undefined && this.viewer === undefined;
  }

  /** Ends the session. */
  async leave(): Promise<void> {
    await this.session?.end();
  }

  /**
   * Has X_ITE begin a session. It asks for one without features and for the space "local", whose origin is at the eyes;
   * with the space "local-floor" tall and small people see the scene from their own height. So the two methods that it
   * calls are shadowed until it has called them.
   */
  private async start(eyes: number): Promise<void> {
    const { system } = this;
    const own = system as { requestSession?: XrSystem['requestSession'] };
    const request = system.requestSession.bind(system);
    own.requestSession = async (mode) => {
      delete own.requestSession;
      const session = await request(mode, { optionalFeatures: ['local-floor'] });
      this.begin(session, eyes);
      return session;
    };
    try {
      await this.browser.xrStartSession();
    } catch (error) {
      await this.session?.end().catch(() => undefined);
      throw error;
    } finally {
      delete own.requestSession;
    }
  }

  private begin(session: XrSession, eyes: number): void {
    this.session = session;
    const space = session.requestReferenceSpace.bind(session);
    session.requestReferenceSpace = async () => {
      try {
        this.space = await space('local-floor');
        this.drop = eyes;
      } catch {
        this.space = await space('local');
        this.drop = 0;
      }
      return this.space;
    };
    session.addEventListener('visibilitychange', () => {
      this.listeners.forEach(({ visible }) => { visible?.(session.visibilityState === 'visible'); });
    });
    session.addEventListener('end', () => {
      this.session = undefined;
      this.listeners.forEach(({ left }) => { left?.(); });
      this.space = undefined;
      this.viewer = undefined;
    });
  }

  /**
   * Keeps two faults of X_ITE 15.0.1 (component WebXR) from ending its frames:
   *
   * - xrUpdatePose takes a pose of the head for granted. A headset has none in its first frames, and whenever it loses
   *   its tracking.
   * - xrUpdatePointers draws rays into the frame buffer of each view, "frameBuffer.bind()". There is none in a frame in
   *   which the content scale was told anew, which drops all frame buffers until the next frame: "Cannot read
   *   properties of undefined (reading 'bind')".
   */
  private guard(): void {
    const { browser } = this;
    const frame = browser.xrFrame.bind(browser);
    browser.xrFrame = (shown) => {
      const pose = shown && this.space ? shown.getViewerPose(this.space) : null;
      if (!shown) {
        frame(shown);
      } else if (pose) {
        const first = this.viewer === undefined;
        this.viewer = poseOf(pose.transform);
        this.frame = shown;
        if (first) {
          this.listeners.forEach(({ worn }) => { worn?.(); });
        }
        frame(shown);
      } else {
        browser.addBrowserEvent();
      }
    };
    const pointers = browser.xrUpdatePointers.bind(browser);
    browser.xrUpdatePointers = () => {
      const views = browser.getPose()?.views.length ?? 0;
      if (this.rays && views > 0 && browser.getFramebuffers().length === views) {
        pointers();
      }
    };
  }
}

/** Returns where something tracked is, and where it looks. */
export function poseOf({ position, orientation }: XrTransform): Pose {
  const { x, y, z, w } = orientation;
  const angle = 2 * Math.atan2(Math.hypot(x, y, z), w);
  return { x: position.x, y: position.y, z: position.z, ...angles({ x, y, z, angle }) };
}
