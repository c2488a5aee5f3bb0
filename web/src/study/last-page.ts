import type { Wording } from './description.js';
import { element } from './fields.js';
import type { RecordFile } from './record-file.js';

/** Answers that only this page has, and the name of the file that they are saved as. */
export interface Unsaved {
  readonly file: RecordFile;
  readonly name: string;
}

/**
 * Returns what stands at the end of a session: thanks, and how to go on. Answers that no receiver has come first: until
 * the participant has saved them, nothing leads away from the page, and the browser asks before it is closed.
 *
 * @param completion address of the confirmation; empty for none
 */
export function lastPage(words: Wording, completion: string, unsaved?: Unsaved): HTMLElement {
  const page = element('div', 'thanks');
  const thanks = element('h1', '', words.of('thanks.title'));
  if (unsaved === undefined) {
    page.append(thanks, ...leaving(words, completion));
    return page;
  }
  const said = element('p', '', words.of('web.save.first'));
  said.setAttribute('role', 'status');
  const save = unsaved.file.link(words.of('web.save'), unsaved.name);
  const ask = (event: Event): void => { event.preventDefault(); };
  window.addEventListener('beforeunload', ask);
  save.addEventListener('click', () => {
    window.removeEventListener('beforeunload', ask);
    said.textContent = words.of('web.save.again', unsaved.name);
    page.append(...leaving(words, completion));
    page.prepend(thanks);
  }, { once: true });
  page.append(said, save);
  return page;
}

/** Returns how the participant leaves the page. */
function leaving(words: Wording, completion: string): HTMLElement[] {
  if (completion === '') {
    return [element('p', '', words.of('web.thanks'))];
  }
  const link = document.createElement('a');
  link.href = completion;
  link.className = 'jspsych-btn';
  link.textContent = words.of('web.completion.link');
  return [element('p', '', words.of('web.completion')), link];
}
