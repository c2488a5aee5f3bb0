import type { World } from '../scene/world.js';
import type { Words } from './words.js';

/** Shows what the overlay of the command run shows: frame rate, areas, and the version of each object. */
export class Details {
  private frames = 0;
  private since = performance.now();

  constructor(
    private readonly element: HTMLElement,
    private readonly world: World,
    private readonly words: Words,
  ) {}

  /** Counts a frame; the text follows twice a second. */
  frame(): void {
    this.frames++;
    const now = performance.now();
    if (now - this.since < 500) {
      return;
    }
    const rate = Math.round((1000 * this.frames) / (now - this.since));
    this.frames = 0;
    this.since = now;
    if (!this.element.hidden) {
      this.element.replaceChildren(...this.lines(rate));
    }
  }

  private lines(rate: number): HTMLElement[] {
    const areas = this.world.entered();
    const head = [this.words.frames(rate), `${this.words.areas}: ${areas.length > 0 ? areas.join(', ') : this.words.none}`];
    const objects = this.world.objects.map((object) => {
      const choice = this.world.choice(object);
      return `${object}: ${choice < 0 ? this.words.hidden : choice}`;
    });
    return [...head, `${this.words.objects}:`, ...objects].map((text) => {
      const line = this.element.ownerDocument.createElement('div');
      line.textContent = text;
      return line;
    });
  }
}
