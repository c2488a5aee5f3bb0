import { Progress } from '../page/progress.js';
import { Input } from '../scene/input.js';
import { Walker } from '../scene/walker.js';
import { World } from '../scene/world.js';
import type { StudyScene, Wording } from './description.js';

/** The scene that is shown behind the questions and hidden between exposures. */
export class Stage {
  private shownScene = '';
  private world: World | undefined;
  private walker: Walker | undefined;
  private readonly input: Input;

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

  /** Loads a scene, unless it is there already, and says how far that is. */
  async open(name: string, words: Wording, say: (text: string) => void): Promise<{ world: World; walker: Walker }> {
    const scene = this.scenes[name];
    if (!scene) {
      throw new Error(`study-web.json has no scene ${name}; export the study anew`);
    }
    if (this.world && this.walker && this.shownScene === name) {
      this.world.browser.beginUpdate();
      return { world: this.world, walker: this.walker };
    }
    this.world?.browser.beginUpdate();
    const loaded = new AbortController();
    new Progress(scene.files, location.href, (percent) => { say(words.of('web.loading', percent)); }).follow(loaded.signal);
    try {
      this.world = await World.open(this.canvas, scene);
    } finally {
      loaded.abort();
    }
    this.world.browser.setBrowserOption('Mute', this.mute);
    this.walker = new Walker(this.world, this.input);
    this.shownScene = name;
    return { world: this.world, walker: this.walker };
  }

  /** Shows the picture, with the part of its brightness that is wanted. */
  show(brightness: number): void {
    this.box.hidden = false;
    this.box.style.visibility = 'visible';
    this.curtain.style.opacity = String(1 - brightness);
  }

  /** Hides the picture, and stops drawing it. */
  hide(): void {
    this.box.style.visibility = 'hidden';
    this.curtain.style.opacity = '1';
    this.input.release();
    this.world?.browser.endUpdate();
  }

  /** Lets all keys and fingers go. */
  release(): void {
    this.input.release();
    this.input.dragged();
  }
}
