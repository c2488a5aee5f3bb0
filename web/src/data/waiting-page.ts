import type { Waiting } from './sink.js';
import type { DataWords } from './words.js';

/** After so many milliseconds of waiting a file is offered. */
const PATIENCE = 30_000;

/** Tells in an element of the page that data are on the way, and offers them as a file if that takes long. */
export class WaitingPage implements Waiting {
  private readonly sentence: HTMLElement;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly root: HTMLElement,
    private readonly words: DataWords,
    private readonly patience = PATIENCE,
  ) {
    this.sentence = root.ownerDocument.createElement('p');
    this.sentence.setAttribute('role', 'status');
  }

  begin(name: string, left: () => Promise<string[]>): Promise<void> {
    this.root.replaceChildren(this.sentence);
    this.sentence.textContent = this.words.sending;
    return new Promise((leave) => {
      this.timer = setTimeout(() => {
        this.offer(name, left, leave);
      }, this.patience);
    });
  }

  trouble(trouble: string | undefined): void {
    this.sentence.textContent = trouble === undefined ? this.words.sending : this.words.trouble;
    this.sentence.title = trouble ?? ''; // for the researcher who is asked
  }

  end(): void {
    clearTimeout(this.timer);
    this.root.replaceChildren();
  }

  private offer(name: string, left: () => Promise<string[]>, leave: () => void): void {
    const save = this.button(this.words.save, async () => {
      download(this.root.ownerDocument, name, (await left()).map((record) => record + '\n').join(''));
      const saved = this.root.ownerDocument.createElement('p');
      saved.textContent = this.words.saved;
      const go = this.button(this.words.leave, () => {
        leave();
        return Promise.resolve();
      });
      this.root.replaceChildren(this.sentence, save, saved, go);
    });
    this.root.append(save);
  }

  private button(text: string, pressed: () => Promise<void>): HTMLButtonElement {
    const button = this.root.ownerDocument.createElement('button');
    button.type = 'button';
    button.textContent = text;
    button.addEventListener('click', () => void pressed());
    return button;
  }
}

function download(page: Document, name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'application/jsonl' }));
  const link = page.createElement('a');
  link.href = url;
  link.download = name;
  page.body.append(link);
  link.click();
  link.remove();
  // At once, some browsers would not have begun to read.
  setTimeout(() => {
    URL.revokeObjectURL(url);
  }, 60_000);
}
