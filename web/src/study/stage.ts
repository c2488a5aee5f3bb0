import { Progress, rising } from '../page/progress.js';
import { Headset } from '../scene/headset.js';
import { Input } from '../scene/input.js';
import { Walker } from '../scene/walker.js';
import type { XrInputEvent } from '../scene/webxr.js';
import { World } from '../scene/world.js';
import { browserOf } from '../scene/xite.js';
import type { StudyScene, Wording } from './description.js';
import { PanelQuestionnaire, picturesOf, pointable } from './headset/panel-questionnaire.js';
import { HeadsetRoom } from './headset/room.js';
import type { Target } from './headset/sheet.js';
import type { QuestionnaireState } from './questionnaire-state.js';

declare global {
  interface Window {
    /** What can be pressed on the panel in a headset, for programs that drive the page. */
    studyPanel?: () => readonly Target[] | undefined;
  }
}

/** The scene that is shown behind the questions and hidden between exposures. */
export class Stage {
  private shownScene = '';
  private world: World | undefined;
  private walker: Walker | undefined;
  private readonly input: Input;

  /** Whether a participant who has a headset chose the screen. */
  onScreen = false;
  /** Called when a participant in a headset squeezes a controller. */
  squeezed: (() => void) | undefined;
  /** Called when the headset is taken off, put on again or left. */
  interrupted: ((event: string) => void) | undefined;

  private headset: Headset | undefined;
  private room: HeadsetRoom | undefined;
  private showing = false;
  private left: () => void = () => undefined;

  /**
   * @param box holds the canvas and the curtain
   * @param canvas X_ITE's element
   * @param curtain the black sheet before the picture
   */
  constructor(
    private readonly box: HTMLElement,
    private readonly canvas: HTMLElement,
    private readonly curtain: HTMLElement,
    private readonly scenes: Readonly<Record<string, StudyScene>>,
    private readonly mute: boolean,
  ) {
    // The curtain is before the canvas, so that it gets what is pressed and dragged.
    this.input = new Input(curtain, new AbortController().signal);
    this.hide();
  }

  /** Loads a scene, unless it is there already, and says the percentage that is there. */
  async open(name: string, say: (percent: number) => void): Promise<{ world: World; walker: Walker }> {
    const scene = this.scenes[name];
    if (!scene) {
      throw new Error(`study-web.json has no scene ${name}; export the study anew`);
    }
    if (this.world && this.walker && this.shownScene === name) {
      this.world.browser.beginUpdate();
      return this.told(this.world, this.walker);
    }
    this.world?.browser.beginUpdate();
    const loaded = new AbortController();
    new Progress(scene.files, location.href, rising(say)).follow(loaded.signal);
    try {
      this.world = await World.open(this.canvas, scene);
    } finally {
      loaded.abort();
    }
    this.world.browser.setBrowserOption('Mute', this.mute);
    this.walker = new Walker(this.world, this.input);
    this.shownScene = name;
    this.room = undefined;
    if (this.headset?.worn) {
      this.room = new HeadsetRoom(this.world, this.headset);
      this.world.wear(this.headset);
      this.room.enter();
    }
    return this.told(this.world, this.walker);
  }

  /** Returns the scene and what walks in it, which programs that drive the page get too. */
  private told(world: World, walker: Walker): { world: World; walker: Walker } {
    window.selectiveRenderer = { world, walker, headset: this.headset };
    window.studyPanel = () => (this.worn ? this.room?.sheet?.targets : undefined);
    return { world, walker };
  }

  /** Makes everything dark before an exposure; in a headset the viewer leaves the room of the questions. */
  darken(): void {
    if (this.worn) {
      this.room?.leave();
    }
  }

  /** Shows the picture, with the part of its brightness that is wanted. */
  show(brightness: number): void {
    this.showing = true;
    this.box.hidden = false;
    this.box.style.visibility = 'visible';
    this.curtain.style.opacity = String(1 - brightness);
    if (this.worn) {
      this.room?.curtain(brightness);
    }
  }

  /** Hides the picture, and stops drawing it; in a headset the room of the questions is seen. */
  hide(): void {
    this.showing = false;
    this.box.style.visibility = 'hidden';
    this.curtain.style.opacity = '1';
    this.input.release();
    if (this.worn) {
      this.room?.enter();
    } else {
      this.world?.browser.endUpdate();
    }
  }

  /** Whether a headset shows the study. */
  get worn(): boolean {
    return this.headset?.worn === true;
  }

  /** Looks for a headset; returns whether the browser knows one. */
  async findHeadset(): Promise<boolean> {
    const headset = await Headset.find(this.canvas, browserOf(this.canvas));
    this.headset = headset;
    headset?.listen({
      worn: () => {
        this.world?.wear(headset);
        this.room?.enter();
        headset.events?.addEventListener('select', (event) => { this.room?.pressed(event as XrInputEvent); });
        headset.events?.addEventListener('squeeze', () => { this.squeezed?.(); });
      },
      visible: (visible) => { this.interrupted?.(visible ? 'headset-on' : 'headset-off'); },
      left: () => { this.unworn(); },
    });
    return headset !== undefined;
  }

  /** Shows the study in the headset from now on; to be called when something is pressed, with a scene open. */
  async enter(): Promise<void> {
    if (this.world && this.headset) {
      this.world.browser.beginUpdate();
      this.room ??= new HeadsetRoom(this.world, this.headset);
      await this.headset.enter(this.world.walker().eyes);
    }
  }

  /** Ends the session of the headset. */
  async leave(): Promise<void> {
    await this.headset?.leave();
  }

  /** Tells something in the headset; returns whether the button was pressed, false if the headset was left. */
  async tell(lines: readonly string[], button: string): Promise<boolean> {
    const { room } = this;
    if (!room) {
      return false;
    }
    const pressed = new Promise<boolean>((resolve) => {
      room.show((sheet) => {
        lines.forEach((line) => { sheet.text(line); });
        sheet.buttons({ text: button, pressed: () => { resolve(true); } });
      });
    });
    const answered = await Promise.race([pressed, this.gone()]);
    room.clear();
    return answered;
  }

  /**
   * Asks a questionnaire in the headset, if one is worn; returns whether it was answered there. Who cannot answer it by
   * pointing takes the headset off.
   */
  async ask(state: QuestionnaireState, words: Wording): Promise<boolean> {
    const { room } = this;
    if (!this.worn || !room) {
      return false;
    }
    if (!pointable(state.pages)) {
      await this.tell([words.of('web.headset.take-off')], words.of('next'));
      await this.leave();
      return false;
    }
    const gone = this.gone(); // from now on: the headset may be left while pictures are loaded
    const pictures = await Promise.race([picturesOf(state.pages), gone]);
    if (pictures) {
      new PanelQuestionnaire(room, state, words, pictures);
    }
    const answered = await Promise.race([state.result.then(() => true), gone]);
    room.clear();
    return answered;
  }

  private gone(): Promise<false> {
    return new Promise((resolve) => { this.left = () => { resolve(false); }; });
  }

  private unworn(): void {
    this.interrupted?.('headset-left');
    this.room?.leave();
    this.room?.curtain(1);
    this.world?.wear(undefined);
    if (!this.showing) {
      this.hide();
    }
    this.left();
  }

  /** Lets all keys and fingers go. */
  release(): void {
    this.input.release();
    this.input.dragged();
  }
}
