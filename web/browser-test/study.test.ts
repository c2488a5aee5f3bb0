import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from 'puppeteer-core';
import { expect, it } from 'vitest';
import { ROOT, launch, selectiveRenderer, serve, temporary } from './chromium.js';

/** A study of one exposure: consent, a page of text, two seconds in the office, one question. */
function study(folder: string): string {
  const scene = path.relative(folder, path.join(ROOT, 'scenes', 'trashcan.x3d')).split(path.sep).join('/');
  writeFileSync(
    path.join(folder, 'closing.json'),
    JSON.stringify({
      name: 'closing',
      pages: [{ title: 'Thank you', questions: [{ id: 'noticed', kind: 'text', text: 'What did you notice?' }] }],
    }),
  );
  writeFileSync(
    path.join(folder, 'things.csv'),
    'area,object,consistency,present,en\noffice,trashcan,consistent,yes,Trash can\noffice,boat,inconsistent,no,Boat\n',
  );
  writeFileSync(
    path.join(folder, 'study.json'),
    JSON.stringify({
      name: 'Office',
      scene,
      conditions: ['selective', 'high'],
      participants: 4,
      areas: [{ name: 'office', viewpoint: 'OfficeView', seconds: 2 }],
      fade: 0.1,
      questionnaires: [{ kind: 'recognition', items: 'things.csv' }, { file: 'closing.json' }],
    }),
  );
  return path.join(folder, 'study.json');
}

/** Fills in what the page asks, and goes on; returns what stands on the page. */
async function answer(page: Page): Promise<string> {
  return page.evaluate(() => {
    const seen = document.body.innerText;
    for (const box of document.querySelectorAll<HTMLElement>('.choice')) {
      const first = box.querySelector<HTMLInputElement>('input');
      if (first && !box.querySelector('input:checked')) {
        first.click();
      }
    }
    for (const line of document.querySelectorAll<HTMLInputElement>('form textarea, form input:not([type=radio], [type=checkbox])')) {
      line.value = 'the trash can';
      line.dispatchEvent(new Event('input', { bubbles: true }));
      line.dispatchEvent(new Event('change', { bubbles: true }));
    }
    const buttons = [...document.querySelectorAll<HTMLButtonElement>('button')].filter((button) => button.offsetParent);
    (buttons.find((button) => button.type === 'submit') ?? buttons[0])?.click();
    return seen;
  });
}

const RECEIVE = path.join(ROOT, 'tools', 'web-receiver', 'receive.py');

/** Starts the reference receiver for pages of an origin; returns its address. */
async function receiver(database: string, origin: string): Promise<{ url: string; child: ChildProcess }> {
  const options = ['--study', 'Office', '--origin', origin, '--slots', '4', '--port', '0'];
  const child = spawn('python3', [RECEIVE, database, ...options], { stdio: ['ignore', 'pipe', 'inherit'] });
  const [first] = (await once(child.stdout, 'data')) as [Buffer];
  const url = /http:\/\/\S+?:\d+/.exec(first.toString())?.[0];
  if (!url) {
    throw new Error(`the receiver does not say where it listens: ${first.toString()}`);
  }
  return { url, child };
}

interface Received {
  step?: string;
  slot?: number;
  condition?: string;
  [key: string]: unknown;
}

it('is taken part in from consent to data', async () => {
  const { folder, remove } = temporary();
  const site = path.join(folder, 'site');
  selectiveRenderer('experiment', 'export', study(folder), '--to', 'web', site);
  const server = await serve(site);
  const database = path.join(folder, 'office.sqlite');
  const { url, child } = await receiver(database, new URL(server.url).origin);
  const settings = path.join(site, 'study-settings.json');
  writeFileSync(settings, JSON.stringify({ ...(JSON.parse(readFileSync(settings, 'utf8')) as object), receiver: `${url}/` }));
  const browser = await launch();
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.setViewport({ width: 820, height: 520 });
  await page.goto(`${server.url}?PROLIFIC_PID=robot&lang=en`);
  let seen = '';
  for (let i = 0; i < 90 && !seen.includes('All is done.'); i++) {
    seen = await answer(page);
    await new Promise((later) => setTimeout(later, 500));
  }
  expect(seen).toContain('All is done.');
  expect(errors).toEqual([]);

  const data = path.join(folder, 'data');
  execFileSync('python3', [RECEIVE, database, '--write', data]);
  const sessions = readdirSync(data).filter((name) => name.endsWith('.jsonl'));
  expect(sessions).toHaveLength(1);
  const records = readFileSync(path.join(data, sessions[0] ?? ''), 'utf8').trim().split('\n').map((line) => JSON.parse(line) as Received);
  expect(records.map((record) => record.step)).toEqual(['form', 'exposure-office', 'recognition-office', 'closing']);
  expect(records.map((record) => record.slot)).toEqual([1, 1, 1, 1]);
  expect(JSON.stringify(records[0])).toContain('robot');
  expect(JSON.stringify(records[3])).toContain('the trash can');
  expect(JSON.stringify(records[1])).toMatch(/"log":\[?/);
  await browser.close();
  server.close();
  child.kill();

  // What arrived becomes a session like those of the laboratory.
  const responses = path.join(folder, 'responses.csv');
  const collect = ['experiment', 'collect', folder, '--web', data, '--responses', responses];
  selectiveRenderer(...collect);
  expect(readFileSync(responses, 'utf8')).toMatch(/^web001,[a-z]+,office,trashcan,consistent,yes,yes,/m);
  const head = readFileSync(path.join(folder, 'sub-web001', 'ses-01', 'head', 'exposure-office_run-01.csv'), 'utf8');
  expect(head).toMatch(/,moved,Inline_\w+,/); // what was in view is found in the scene
  expect(selectiveRenderer('experiment', 'analyse', responses)).toContain('hit rate');
  selectiveRenderer(...collect);
  expect(readdirSync(folder).filter((name) => name.startsWith('sub-'))).toEqual(['sub-web001']);
  remove();
}, 240_000);
