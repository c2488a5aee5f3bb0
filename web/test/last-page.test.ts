// @vitest-environment happy-dom
import { resolveObjectURL } from 'node:buffer';
import { afterEach, describe, expect, it } from 'vitest';
import { Wording } from '../src/study/description.js';
import { lastPage } from '../src/study/last-page.js';
import { RecordFile } from '../src/study/record-file.js';

const WORDS = new Wording({
  'thanks.title': 'Thank you',
  'web.thanks': 'You can close this page.',
  'web.completion': 'Please go on here.',
  'web.completion.link': 'Confirm',
  'web.save': 'Save my answers',
  'web.save.first': 'Your answers are not saved yet.',
  'web.save.again': 'They are in {0}.',
});

describe('the last page', () => {
  afterEach(() => { document.body.replaceChildren(); });

  function shown(saving: boolean, completion = ''): HTMLElement {
    const file = new RecordFile();
    file.send({ answer: 1 });
    const page = lastPage(WORDS, completion, saving ? { file, name: 'session.jsonl' } : undefined);
    document.body.append(page);
    return page;
  }

  function save(page: HTMLElement): HTMLAnchorElement {
    const found = page.querySelector<HTMLAnchorElement>('a[download]');
    if (!found) {
      throw new Error('nothing saves the answers');
    }
    return found;
  }

  /** Returns whether the browser asks before the page is closed. */
  function asksBeforeClosing(): boolean {
    const closing = new Event('beforeunload', { cancelable: true });
    window.dispatchEvent(closing);
    return closing.defaultPrevented;
  }

  it('lets the participant go at once when a receiver has the answers', () => {
    const page = shown(false);
    expect(page.textContent).toContain('You can close this page.');
    expect(page.querySelector('a[download]')).toBeNull();
    expect(asksBeforeClosing()).toBe(false);
  });

  it('says first that the answers are not saved, and not that the page can be closed', async () => {
    const page = shown(true);
    expect(page.textContent).not.toContain('Thank you');
    expect(page.textContent).not.toContain('You can close this page.');
    const said = page.querySelector('[role=status]');
    expect(said?.textContent).toBe('Your answers are not saved yet.');
    expect(said?.compareDocumentPosition(save(page))).toBe(Node.DOCUMENT_POSITION_FOLLOWING);
    expect(await resolveObjectURL(save(page).href)?.text()).toBe('{"answer":1}\n');
    expect(asksBeforeClosing()).toBe(true);
    save(page).click();
  });

  it('lets the participant go after the button was pressed, and keeps the button', () => {
    const page = shown(true);
    save(page).click();
    expect(page.textContent).toContain('Thank you');
    expect(page.textContent).toContain('They are in session.jsonl.');
    expect(page.textContent).toContain('You can close this page.');
    expect(page.textContent).not.toContain('not saved yet');
    expect(save(page).isConnected).toBe(true);
    expect(asksBeforeClosing()).toBe(false);
    save(page).click();
    expect(page.textContent.split('You can close this page.')).toHaveLength(2);
  });

  it('leads on to the confirmation only after the answers were saved', () => {
    const page = shown(true, 'https://example.org/done');
    expect(page.querySelector('a:not([download])')).toBeNull();
    save(page).click();
    expect(page.querySelector<HTMLAnchorElement>('a:not([download])')?.href).toBe('https://example.org/done');
  });
});
