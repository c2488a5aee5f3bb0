import { execFileSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { expect, it } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { fillForm, officeStudy, press, set, told, writeAnswer, type Received } from './study-robot.js';

/**
 * A stand-in for jatos.js, with what its reference tells of the functions that the page calls; it keeps in the page what
 * JATOS would. JATOS itself is no package that a test can run.
 */
const STAND_IN = `
  const kept = { results: [], batch: { next: 3 }, ended: [] };
  window.kept = kept;
  window.jatos = {
    studyResultId: 41,
    urlQueryParameters: { PROLIFIC_PID: 'robot', lang: 'en' },
    onLoad: (ready) => setTimeout(ready, 0),
    appendResultData: async (text) => { kept.results.push(text); },
    endStudyWithoutRedirect: async (successful) => { kept.ended.push(successful); },
    batchSession: {
      get: (name) => kept.batch[name],
      set: async (name, value) => { kept.batch[name] = value; },
    },
  };
`;

interface Kept {
  readonly results: readonly string[];
  readonly batch: Readonly<Record<string, unknown>>;
  readonly ended: readonly boolean[];
}

it('hands the records of a study to JATOS, and ends the run there', async () => {
  const { folder, remove } = temporary();
  const archive = path.join(folder, 'office.jzip');
  selectiveRenderer('experiment', 'export', officeStudy(folder), '--to', 'jatos', archive);
  const assets = path.join(folder, 'assets');
  execFileSync('python3', ['-m', 'zipfile', '-e', archive, assets]);
  const study = readdirSync(assets).find((name) => !name.endsWith('.jas')) ?? '';
  const site = path.join(assets, study);
  writeFileSync(path.join(site, 'jatos.js'), STAND_IN);
  set(site, { fullScreen: false, minWidth: 300, minHeight: 200 });
  const server = await serve(site);
  const browser = await launch();
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.setViewport({ width: 640, height: 480 });
  await page.goto(server.url);
  await fillForm(page, 0);
  await told(page, 'Next you see a place for 2 seconds');
  await press(page, 'Begin');
  await writeAnswer(page, 'a lamp');
  await told(page, 'All is done.');
  const kept = await page.evaluate(() => (window as unknown as { kept: Kept }).kept);
  const records = kept.results.flatMap((part) => (JSON.parse(part) as { records: Received[] }).records);
  expect(records.map((record) => record.step)).toEqual(['form', 'exposure-office', 'memory-office', 'closing']);
  expect(records.map((record) => record.slot)).toEqual([3, 3, 3, 3]);
  expect(records[0]?.recruitment).toEqual({ PROLIFIC_PID: 'robot' });
  expect(kept.batch).toEqual({ next: 4 });
  expect(kept.ended).toEqual([true]);
  expect(errors).toEqual([]);
  await browser.close();
  server.close();
  remove();
}, 300_000);
