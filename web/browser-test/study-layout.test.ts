import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { press, set, told } from './study-robot.js';

const { folder, remove } = temporary();
/** A folder for the pictures of docs/web-study.md, which docs/pictures.sh takes; without it none are taken. */
const PICTURES = process.env.PICTURES;

let server: Awaited<ReturnType<typeof serve>>;
let browser: Browser;

const scale = (id: string, en: string, el: string): object => ({
  id,
  kind: 'scale',
  to: 7,
  text: { en, el },
  least: { en: 'not at all', el: 'καθόλου' },
  most: { en: 'very much so', el: 'πάρα πολύ' },
});

/** A study of questions alone: a list of objects, scales, and one of each other kind. */
function questions(): string {
  const study = path.join(folder, 'study');
  mkdirSync(study);
  writeFileSync(path.join(study, 'list.csv'), [
    'area,object,consistency,present,en,el',
    'desk,lamp,consistent,yes,desk lamp,λάμπα γραφείου',
    'desk,kettle,inconsistent,no,kettle,βραστήρας',
    'desk,pen,consistent,no,pen,στυλό',
  ].join('\n'));
  writeFileSync(path.join(study, 'more.json'), JSON.stringify({
    name: 'more',
    pages: [{
      title: { en: 'Being there', el: 'Η παρουσία σας εκεί' },
      questions: [
        scale('there', 'Did you have the sense of being there?', 'Είχατε την αίσθηση ότι βρισκόσασταν εκεί;'),
        scale('real', 'How real was the room to you?', 'Πόσο αληθινό ήταν για εσάς το δωμάτιο;'),
        {
          id: 'light',
          kind: 'slider',
          text: { en: 'How bright was it?', el: 'Πόσο φωτεινό ήταν;' },
          least: { en: 'dark', el: 'σκοτεινό' },
          most: { en: 'like a day in summer', el: 'σαν καλοκαιρινή μέρα' },
        },
        {
          id: 'order',
          kind: 'ranking',
          text: { en: 'Order these rooms by how much you liked them.', el: 'Βάλτε τα δωμάτια στη σειρά που σας άρεσαν.' },
          options: [
            { value: 'kitchen', text: { en: 'Kitchen', el: 'Κουζίνα' } },
            { value: 'lounge', text: { en: 'The lounge with the sofa', el: 'Το σαλόνι με τον καναπέ' } },
          ],
        },
        { id: 'noticed', kind: 'text', optional: true, text: { en: 'What did you notice?', el: 'Τι παρατηρήσατε;' } },
      ],
    }],
  }));
  writeFileSync(path.join(study, 'study.json'), JSON.stringify({
    name: 'Questions',
    languages: ['en', 'el'],
    conditions: ['high'],
    participants: 1,
    areas: [],
    item_areas: ['desk'],
    questionnaires: [{ kind: 'recognition', items: 'list.csv' }, { file: 'more.json' }],
  }));
  return path.join(study, 'study.json');
}

beforeAll(async () => {
  const site = path.join(folder, 'site');
  selectiveRenderer('experiment', 'export', questions(), '--to', 'web', site);
  set(site, { fullScreen: false, minWidth: 300, minHeight: 200 });
  server = await serve(site);
  browser = await launch();
}, 120_000);

afterAll(async () => {
  await browser.close();
  server.close();
  remove();
});

/** Answers each question by its first option, and goes on. */
async function answer(page: Page, label: string): Promise<void> {
  await page.evaluate(() => {
    document.querySelectorAll<HTMLElement>('.choice').forEach((box) => box.querySelector('input')?.click());
    document.querySelectorAll<HTMLElement>('.ranking > button').forEach((button) => { button.click(); });
    document.querySelectorAll<HTMLInputElement>('input[type=range]').forEach((slider) => {
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    });
  });
  await press(page, label);
}

async function picture(page: Page, name: string): Promise<void> {
  if (PICTURES) {
    await page.screenshot({ path: path.join(PICTURES, `${name}.png`) });
  }
}

/** Returns what is wrong with the layout for a finger: what is clipped, too small, or not in its row. */
function faults(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const wrong: string[] = [];
    if (document.documentElement.scrollWidth > window.innerWidth) {
      wrong.push(`the page is ${document.documentElement.scrollWidth} pixels wide`);
    }
    document.querySelectorAll<HTMLElement>('.option, button, .line input, .slider input').forEach((target) => {
      const { height, left, right } = target.getBoundingClientRect();
      if (height < 44 || left < 0 || right > window.innerWidth) {
        wrong.push(`${target.className || target.tagName} '${target.innerText}': ${height} high, ${left} to ${right}`);
      }
    });
    document.querySelectorAll('.scale').forEach((each) => {
      const tops = new Set([...each.querySelectorAll('.option')].map((option) => Math.round(option.getBoundingClientRect().top)));
      if (tops.size > 1) {
        wrong.push(`a scale has ${tops.size} rows`);
      }
    });
    return wrong;
  });
}

it.each([
  ['en', 'Begin', 'Continue', 'desk lamp', 'Being there', 'Save my answers'],
  ['el', 'Έναρξη', 'Συνέχεια', 'λάμπα γραφείου', 'Η παρουσία σας εκεί', 'Αποθήκευση των απαντήσεών μου'],
])('fits a phone and its fingers (%s)', async (lang, begin, next, list, more, end) => {
  const page = await browser.newPage();
  await page.setViewport({ width: 390, height: 844, deviceScaleFactor: 2, hasTouch: true, isMobile: true });
  await page.goto(`${server.url}?slot=1&lang=${lang}`);
  await told(page, begin);
  expect(await faults(page)).toEqual([]);
  await press(page, begin);
  await page.waitForSelector('form.questionnaire');
  expect(await faults(page)).toEqual([]);
  await answer(page, next);
  await told(page, list);
  expect(await faults(page)).toEqual([]);
  await answer(page, next);
  await told(page, more);
  expect(await faults(page)).toEqual([]);
  if (lang === 'en') {
    await picture(page, 'web-study-phone');
  }
  await answer(page, next);
  await told(page, end);
  await page.close();
}, 200_000);

it('is one column of a readable width on a wide screen', async () => {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  await page.goto(`${server.url}?slot=1&lang=en`);
  await press(page, 'Begin');
  await page.waitForSelector('form.questionnaire');
  await answer(page, 'Continue');
  await told(page, 'desk lamp');
  const width = await page.evaluate(() => document.querySelector('form')?.getBoundingClientRect().width ?? 0);
  expect(width).toBeGreaterThan(500);
  expect(width).toBeLessThan(850);
  await page.setViewport({ width: 900, height: 640 });
  await picture(page, 'web-study-list');
  await page.close();
}, 200_000);
