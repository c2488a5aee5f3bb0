import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, expect, it, vi } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { blocksStudy, fillForm, press, ReferenceReceiver, set, told } from './study-robot.js';

/** A folder for pictures to look at; without it none are taken. */
const PICTURES = process.env.PICTURES;

const { folder, remove } = temporary();
const site = path.join(folder, 'site');
let server: Awaited<ReturnType<typeof serve>>;
let receiver: ReferenceReceiver;
let browser: Browser;

beforeAll(async () => {
  selectiveRenderer('experiment', 'export', blocksStudy(folder), '--to', 'web', site);
  server = await serve(site);
  receiver = await ReferenceReceiver.start(folder, new URL(server.url).origin, 'Sides');
  set(site, { receiver: receiver.url, fullScreen: false, minWidth: 300, minHeight: 200, minFrameRate: 0 });
  browser = await launch();
}, 120_000);

afterAll(async () => {
  await browser.close();
  await receiver.stop();
  server.close();
  remove();
});

async function picture(page: Page, name: string): Promise<void> {
  if (PICTURES) {
    await page.screenshot({ path: path.join(PICTURES, `${name}.png`) });
  }
}

/** Waits until an exposure is shown. */
async function exposed(page: Page): Promise<void> {
  await page.waitForFunction(() => document.querySelector<HTMLElement>('#curtain')?.style.opacity === '0', { timeout: 120_000, polling: 'raf' });
}

async function answer(page: Page, option: number): Promise<void> {
  await page.waitForSelector('form.questionnaire .choice, form.questionnaire input[type=range]', { timeout: 120_000 });
  await page.evaluate((index) => {
    const options = [...document.querySelectorAll<HTMLInputElement>('form.questionnaire input[type=radio]')];
    options.at(index)?.click();
  }, option);
  await press(page, 'Continue');
}

it('runs a practice until it is passed, and a block with questions, as the plan of the command run has them', async () => {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.setViewport({ width: 640, height: 480 });
  await page.goto(`${server.url}?PROLIFIC_PID=robot&lang=en`);
  await fillForm(page, 0);
  await told(page, '2 short trials');
  await picture(page, 'block');
  await press(page, 'Begin');

  // The first round of the practice: one right, one wrong; the second: both right.
  for (const [key, feedback] of [['f', 'Right: left'], ['f', 'Wrong: right'], ['f', 'Right: left'], ['j', 'Right: right']] as const) {
    await told(page, 'On which side is it?');
    await picture(page, 'instruction');
    await page.keyboard.press('Space');
    await exposed(page);
    await picture(page, 'exposure');
    // Also after a trial that held what the condition high shows.
    expect(await page.evaluate(() => window.selectiveRenderer?.world.choice('Left'))).toBe(0);
    await page.keyboard.press(key);
    await told(page, feedback);
    await picture(page, 'feedback');
  }

  await told(page, '4 short trials');
  await press(page, 'Begin');
  for (let trial = 1; trial <= 4; trial++) {
    if (trial === 3) {
      await told(page, 'You may rest now');
      await press(page, 'Continue');
    }
    await exposed(page);
    await picture(page, `main-${trial}`);
    await page.keyboard.press('f');
    await answer(page, trial - 1);
  }
  await told(page, 'All is done.');
  expect(errors).toEqual([]);
  await page.close();

  const { records, data } = receiver.written();
  const [all = []] = records;
  expect(all.map((record) => record.step)).toEqual([
    'form',
    'training-001', 'training-002', 'training-round2-001', 'training-round2-002', 'training',
    'main-001', 'main-002', 'main-003', 'main-004', 'main',
  ]);
  const shown = all.find((record) => record.step === 'main-001');
  expect(shown?.phases?.map((each) => each.phase)).toSatisfy((phases: string[]) =>
    ['fixation,exposure,questions', 'fixation,exposure,blank,questions'].includes(phases.join())); // by how fast the robot is
  expect(shown?.log?.rows.some((row) => row[8] === 1)).toBe(true);

  const trials = path.join(folder, 'trials.csv');
  selectiveRenderer('experiment', 'collect', folder, '--web', data, '--trials', trials, '--practice');
  const rows = readFileSync(trials, 'utf8').trim().split('\n').map((row) => row.split(','));
  const [columns = []] = rows;
  // The columns of the tables that sessions of the laboratory leave.
  expect(columns.join()).toBe('participant,session,group,block,trial,round,task,wall,side,choices,answer,response,ms,correct,sure.sure');
  const told4 = rows.slice(1).map((row) => [row[3], row[4], row[5], row[8], row[11], row[13], row[14]].join());
  expect(told4.slice(0, 4)).toEqual([
    'training,1,1,left,f,yes,',
    'training,2,1,right,f,no,',
    'training,1,2,left,f,yes,',
    'training,2,2,right,j,yes,',
  ]);
  const plan = selectiveRenderer('experiment', 'plan', folder, '--format', 'csv').trim().split('\n').map((row) => row.split(','));
  const [heads = []] = plan;
  const cell = (row: readonly string[], column: string): string => row[heads.indexOf(column)] ?? '';
  const slot = String(all[0]?.slot);
  const planned = plan.slice(1)
    .filter((row) => Number(cell(row, 'place')) === Number(slot) && cell(row, 'block') === 'main')
    .map((row) => [
      cell(row, 'trial'),
      /wall=(\w+)/.exec(cell(row, 'levels'))?.[1],
      /side=(\w+)/.exec(cell(row, 'stimulus'))?.[1],
    ].join());
  expect(planned).toHaveLength(4);
  const main = rows.slice(1).filter((row) => row[3] === 'main');
  expect(main.map((row) => [row[4], row[7], row[8]].join())).toEqual(planned);
  expect(main.map((row) => row[14])).toEqual(['1', '2', '3', '4']);
  expect(main.every((row) => row[13] === (row[10] === 'f' ? 'yes' : 'no'))).toBe(true);
}, 400_000);

it('goes on with the trial that a closed page left', async () => {
  const open = async (): Promise<Page> => {
    const page = await browser.newPage();
    await page.setViewport({ width: 640, height: 480 });
    await page.goto(`${server.url}?PROLIFIC_PID=leaves&lang=en`);
    return page;
  };
  const first = await open();
  await fillForm(first, 0);
  await press(first, 'Begin');
  await told(first, 'On which side is it?');
  await first.keyboard.press('Space');
  await exposed(first);
  await first.keyboard.press('f');
  await told(first, 'Right: left');
  await told(first, 'On which side is it?');
  await first.close();

  const page = await open();
  await press(page, 'Begin');
  await told(page, 'It goes on with the trial that was left.');
  await press(page, 'Begin');
  await told(page, 'On which side is it?');
  await page.keyboard.press('Space');
  await exposed(page);
  await page.keyboard.press('j');
  await told(page, 'Right: right');
  await told(page, '4 short trials');
  await vi.waitFor(() => {
    const records = receiver.written().records.find(([form]) => form?.recruitment?.PROLIFIC_PID === 'leaves') ?? [];
    expect(records.map((record) => [record.step, record.repeated])).toEqual([
      ['form', undefined], ['training-001', undefined], ['training-002', true], ['training', undefined],
    ]);
  }, 60_000);
  await page.close();
}, 300_000);
