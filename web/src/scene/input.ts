import { TURN_SPEED, type Intent } from './walk.js';

/** Degrees per pixel by which dragging turns the view. */
const DRAG = 0.25;

/** Milliseconds for which a mouse button must be held still before it walks. */
const HOLD = 150;

/** The largest motion of a hand that holds the mouse still, in pixels. */
const STILL = 4;

const NOTCH = 1.25;
const MOST = 16;

/** Pixels that a finger moves from where it touched until it walks at full speed. */
const STICK = 70;

const FORWARD = new Set(['ArrowUp', 'KeyW']);
const BACKWARD = new Set(['ArrowDown', 'KeyS']);
const LEFT = new Set(['ArrowLeft']);
const RIGHT = new Set(['ArrowRight']);
const STEP_LEFT = new Set(['KeyA']);
const STEP_RIGHT = new Set(['KeyD']);
const ALL = new Set([...FORWARD, ...BACKWARD, ...LEFT, ...RIGHT, ...STEP_LEFT, ...STEP_RIGHT]);

/**
 * Turns keys, mouse and fingers into what the viewer wants, as the command run does: arrow keys and W, A, S, D walk and
 * turn, a mouse button that is held walks (the right one backward), dragging looks around, the wheel sets the speed. A
 * finger in the left half of the picture walks like a joystick, one in the right half looks around.
 */
export class Input {
  private readonly keys = new Set<string>();
  private fast = false;
  private stick: { id: number; x: number; y: number; dx: number; dy: number } | undefined;
  private look: Look | undefined;
  private factor = 1;
  private left = 0;
  private up = 0;

  /**
   * Listens until the signal is aborted.
   *
   * @param element the picture; keys are taken wherever nothing else of the page has the focus
   */
  constructor(private readonly element: HTMLElement, signal: AbortSignal) {
    const document = element.ownerDocument;
    const options = { signal };
    document.addEventListener('keydown', (event) => { this.key(event, true); }, options);
    document.addEventListener('keyup', (event) => { this.key(event, false); }, options);
    // A key released in another window is never told of here.
    document.defaultView?.addEventListener('blur', () => { this.release(); }, options);
    element.addEventListener('pointerdown', (event) => { this.down(event); }, options);
    element.addEventListener('pointermove', (event) => { this.move(event); }, options);
    for (const end of ['pointerup', 'pointercancel'] as const) {
      element.addEventListener(end, (event) => { this.end(event); }, options);
    }
    element.addEventListener('contextmenu', (event) => { event.preventDefault(); }, options);
    element.addEventListener('wheel', (event) => { this.wheel(event); }, { signal, passive: false });
    element.style.touchAction = 'none';
  }

  /** Returns what is wanted now. */
  intent(): Intent {
    const held = (names: Set<string>): number => ([...names].some((name) => this.keys.has(name)) ? 1 : 0);
    const reach = (pixels: number): number => clamp(pixels / STICK);
    return {
      forward: clamp(held(FORWARD) - held(BACKWARD) - reach(this.stick?.dy ?? 0) + this.button()),
      sideways: clamp(held(STEP_RIGHT) - held(STEP_LEFT) + reach(this.stick?.dx ?? 0)),
      turning: (held(LEFT) - held(RIGHT)) * TURN_SPEED,
      fast: this.fast,
      factor: this.factor,
    };
  }

  /** Returns by how many degrees the view was dragged to the left and up since the last call. */
  dragged(): { left: number; up: number } {
    const turn = { left: this.left, up: this.up };
    this.left = 0;
    this.up = 0;
    return turn;
  }

  /** Lets all keys and fingers go. */
  release(): void {
    this.keys.clear();
    this.fast = false;
    this.stick = undefined;
    this.look = undefined;
  }

  /** Returns the way that a held mouse button walks: 1 forward, -1 backward. */
  private button(): number {
    const look = this.look;
    if (!look || look.touch || look.button === 1 || (!look.walks && (look.moved > STILL || Date.now() - look.since < HOLD))) {
      return 0;
    }
    look.walks = true;
    return look.button === 2 ? -1 : 1;
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const notches = -Math.sign(event.deltaY);
    this.factor = Math.min(MOST, Math.max(1 / MOST, this.factor * NOTCH ** notches));
  }

  private key(event: KeyboardEvent, down: boolean): void {
    this.fast = event.shiftKey;
    if (!ALL.has(event.code) || (down && (event.ctrlKey || event.metaKey || event.altKey || writes(event.target)))) {
      return;
    }
    if (down) {
      this.keys.add(event.code);
      event.preventDefault(); // the arrow keys would move the page
    } else {
      this.keys.delete(event.code);
    }
  }

  private down(event: PointerEvent): void {
    const box = this.element.getBoundingClientRect();
    if (event.pointerType === 'touch' && !this.stick && event.clientX - box.left < box.width / 2) {
      this.stick = { id: event.pointerId, x: event.clientX, y: event.clientY, dx: 0, dy: 0 };
    } else if (!this.look) {
      this.look = {
        id: event.pointerId,
        touch: event.pointerType === 'touch',
        button: event.button,
        since: Date.now(),
        moved: 0,
        walks: false,
        x: event.clientX,
        y: event.clientY,
      };
    } else {
      return;
    }
    this.element.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    if (event.pointerId === this.stick?.id) {
      this.stick.dx = event.clientX - this.stick.x;
      this.stick.dy = event.clientY - this.stick.y;
    } else if (event.pointerId === this.look?.id) {
      const look = this.look;
      const dx = event.clientX - look.x;
      const dy = event.clientY - look.y;
      look.x = event.clientX;
      look.y = event.clientY;
      look.moved += Math.hypot(dx, dy);
      // The view follows the mouse, but a finger takes hold of what it touches and drags that.
      const way = look.touch ? DRAG : -DRAG;
      this.left += dx * way;
      this.up += dy * way;
    }
  }

  private end(event: PointerEvent): void {
    if (event.pointerId === this.stick?.id) {
      this.stick = undefined;
    }
    if (event.pointerId === this.look?.id) {
      this.look = undefined;
    }
  }
}

/** A mouse button that is down, or a finger that looks around. */
interface Look {
  readonly id: number;
  readonly touch: boolean;
  readonly button: number;
  /** When it went down, in milliseconds. */
  readonly since: number;
  /** The way it moved since, in pixels. */
  moved: number;
  walks: boolean;
  x: number;
  y: number;
}

function clamp(value: number): number {
  return Math.min(1, Math.max(-1, value));
}

/** Returns whether keys belong to an element that is written in or chosen from. */
function writes(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('input, select, textarea, [contenteditable]');
}
