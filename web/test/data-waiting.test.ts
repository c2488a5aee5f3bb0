import { Window } from 'happy-dom';
import { describe, expect, it } from 'vitest';
import { WaitingPage } from '../src/data/waiting-page.js';
import { dataWords } from '../src/data/words.js';

describe('the page that waits for data', () => {
  function page(patience: number): { root: HTMLElement; waiting: WaitingPage; window: Window } {
    const window = new Window();
    const root = window.document.createElement('main');
    window.document.body.append(root);
    const element = root as unknown as HTMLElement;
    return { root: element, waiting: new WaitingPage(element, dataWords('en'), patience), window };
  }

  it('tells that data are sent, or cannot be, and goes', async () => {
    const { root, waiting } = page(1e6);
    void waiting.begin('name.jsonl', () => Promise.resolve([]));
    expect(root.textContent).toBe('Your answers are being sent. Please leave this page open.');
    expect(root.querySelector('[role=status]')).not.toBeNull();
    waiting.trouble('<b>500</b>');
    expect(root.textContent).toContain('cannot be sent at the moment');
    expect(root.querySelector('b')).toBeNull();
    waiting.trouble(undefined);
    expect(root.textContent).toContain('are being sent');
    waiting.end();
    expect(root.childElementCount).toBe(0);
    await Promise.resolve();
  });

  it('offers a file when it takes long, and lets the participant go after that only', async () => {
    const { root, waiting, window } = page(1);
    const left = waiting.begin('name.jsonl', () => Promise.resolve(['{"a":1}', '2']));
    while (root.querySelectorAll('button').length < 1) {
      await new Promise((resolve) => setImmediate(resolve));
    }
    let saved: { name: string; text: Promise<string> } | undefined;
    window.document.addEventListener('click', (event) => {
      const target = event.target as unknown as HTMLAnchorElement;
      if (target.tagName === 'A') {
        event.preventDefault();
        saved = { name: target.download, text: fetch(target.href).then((answer) => answer.text()) };
      }
    });
    const save = root.querySelector('button');
    expect(save?.textContent).toBe('Save my answers as a file');
    save?.click();
    while (root.querySelectorAll('button').length < 2) {
      await new Promise((resolve) => setImmediate(resolve));
    }
    expect(saved?.name).toBe('name.jsonl');
    expect(await saved?.text).toBe('{"a":1}\n2\n');
    root.querySelectorAll('button')[1]?.click();
    await left;
  });

  it('speaks Greek and English', () => {
    expect(Object.keys(dataWords('el-GR'))).toEqual(Object.keys(dataWords('fr')));
    expect(dataWords('el').sending).toContain('αποστέλλονται');
  });
});
