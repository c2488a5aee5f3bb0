import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, beforeEach, expect, it, vi } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { fillForm, officeStudy, press, ReferenceReceiver, set, told, writeAnswer, type Received } from './study-robot.js';

const { folder, remove } = temporary();
const site = path.join(folder, 'site');
let server: Awaited<ReturnType<typeof serve>>;
let receiver: ReferenceReceiver;
let browser: Browser;
let attempt = 0;

beforeAll(async () => {
  selectiveRenderer('experiment', 'export', officeStudy(folder), '--to', 'web', site);
  server = await serve(site);
  receiver = await ReferenceReceiver.start(folder, new URL(server.url).origin);
  browser = await launch();
}, 120_000);

beforeEach(() => { set(site, { receiver: `${receiver.url}/`, fullScreen: false, minWidth: 300, minHeight: 200, minFrameRate: 0 }); });

afterAll(async () => {
  await browser.close();
  await receiver.stop();
  server.close();
  remove();
});

async function open(participant: string): Promise<{ page: Page; errors: string[] }> {
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.setViewport({ width: 640, height: 480 });
  await page.goto(`${server.url}?PROLIFIC_PID=${participant}&lang=en`);
  return { page, errors };
}

/** Returns the records of a participant's sessions, one list for each. */
function sessions(participant: string): Received[][] {
  return receiver.written().records.filter((records) => records[0]?.recruitment?.PROLIFIC_PID === participant);
}

it('is taken part in on the full screen, from consent to data', async () => {
  set(site, { fullScreen: true });
  const { page, errors } = await open('robot');
  await press(page, 'Begin');
  await press(page, 'Continue');
  await page.waitForSelector('form.questionnaire', { timeout: 120_000 });
  await page.evaluate(() => {
    document.querySelectorAll<HTMLElement>('.choice').forEach((box) => box.querySelector('input')?.click());
    document.querySelectorAll<HTMLInputElement>('form input:not([type=radio], [type=checkbox])').forEach((line) => {
      line.value = '30';
      line.dispatchEvent(new Event('input', { bubbles: true }));
    });
  });
  await press(page, 'Continue');
  await told(page, 'Next you see a place for 2 seconds');
  await press(page, 'Begin');
  await writeAnswer(page, 'the trash can');
  await told(page, 'All is done.');
  expect(errors).toEqual([]);
  await page.close();

  const [records = [], ...others] = sessions('robot');
  expect(others).toEqual([]);
  expect(records.map((record) => record.step)).toEqual(['form', 'exposure-office', 'memory-office', 'closing']);
  expect(records.map((record) => record.slot)).toEqual([1, 1, 1, 1]);
  expect(records[0]?.device?.scene_rate).toBeGreaterThan(0);
  expect(records[1]?.log?.columns.slice(0, 7)).toEqual(['t', 'x', 'y', 'z', 'yaw', 'pitch', 'roll']);
  expect(records[1]?.log?.rows.length).toBeGreaterThan(0);
  expect(records[3]?.answers?.map(({ question, value }) => [question, value])).toEqual([['noticed', 'the trash can']]);
}, 300_000);

it('loses nothing when the connection is cut in the middle and the tab is closed and opened again', async () => {
  const participant = `cut-${attempt++}`;
  const first = await open(participant);
  await fillForm(first.page, 0);
  await told(first.page, 'Next you see a place for 2 seconds');
  const steps = () => sessions(participant).flat().map((record) => record.step);
  await vi.waitFor(() => { expect(steps()).toEqual(['form']); }, 60_000);
  await receiver.stop();
  try {
    // The exposure is logged and the last page comes, without a connection.
    await press(first.page, 'Begin');
    await first.page.waitForSelector('form.questionnaire', { timeout: 120_000 });
    await first.page.close();
    expect(steps()).toEqual(['form']);
  } finally {
    await receiver.restart();
  }

  const { page, errors } = await open(participant);
  await press(page, 'Begin');
  await writeAnswer(page, 'a lamp');
  await told(page, 'All is done.');
  expect([...first.errors, ...errors]).toEqual([]);
  await page.close();
  const [records = [], ...others] = sessions(participant);
  expect(others).toEqual([]);
  expect(records.map((record) => record.step)).toEqual(['form', 'exposure-office', 'memory-office', 'closing']);
  expect(new Set(records.map((record) => record.session)).size).toBe(1);
  expect(records[1]?.log?.rows.length).toBeGreaterThan(0);
}, 400_000);

it('shows an exposure that was left once more, and says so', async () => {
  const { page } = await open('left');
  await fillForm(page, 0);
  await told(page, 'Next you see a place for 2 seconds');
  // The page is left when the exposure begins, however slowly the scene is drawn.
  await page.evaluate(() => {
    Object.defineProperty(window, 'selectiveRenderer', { set: () => { location.reload(); } });
  });
  await press(page, 'Begin');
  await told(page, 'This study runs in this page.');
  await press(page, 'Begin');
  await told(page, 'It is shown once more.');
  await press(page, 'Begin');
  await writeAnswer(page, 'nothing');
  await told(page, 'All is done.');
  await page.close();
  expect(sessions('left').flat().map((record) => [record.step, record.repeated])).toEqual([
    ['form', undefined],
    ['exposure-office', true],
    ['memory-office', undefined],
    ['closing', undefined],
  ]);
}, 400_000);

it('keeps nothing of who refuses consent', async () => {
  const { page } = await open('refuses');
  await fillForm(page, 1);
  await press(page, 'Do not take part');
  await told(page, 'You do not take part');
  await page.close();
  const refused = receiver.written().records.flat().filter((record) => record.refused);
  expect(refused.map((record) => [record.step, record.answers, record.recruitment])).toEqual([['form', undefined, undefined]]);
}, 200_000);

it('does not begin where the scene is drawn too slowly', async () => {
  set(site, { minFrameRate: 10_000 });
  const taken = receiver.taken();
  const { page } = await open('slow');
  await press(page, 'Begin');
  await told(page, 'the study needs 10000.');
  await press(page, 'Measure again');
  await told(page, 'The place is being prepared.');
  await told(page, 'the study needs 10000.');
  await page.close();
  expect(sessions('slow')).toEqual([]);
  expect(receiver.taken()).toBe(taken); // who is too slow takes no place
}, 200_000);

it('leaves sessions that are collected and analysed like those of the laboratory', () => {
  const { records, data } = receiver.written();
  const responses = path.join(folder, 'responses.csv');
  selectiveRenderer('experiment', 'collect', folder, '--web', data, '--responses', responses);
  const robot = records.find(([first]) => first?.recruitment?.PROLIFIC_PID === 'robot')?.[0]?.slot ?? 0;
  const whole = records.filter((all) => all.some((record) => record.step === 'closing'));
  const rows = readFileSync(responses, 'utf8').trim().split('\n').slice(1);
  expect(rows).toHaveLength(2 * whole.length);
  expect(rows.filter((row) => row.startsWith(`web00${robot},`)).map((row) => row.split(',').slice(2, 8).join()).sort()).toEqual([
    'office,boat,inconsistent,no,yes,1',
    'office,can,consistent,yes,yes,1',
  ]);
  const head = path.join(folder, `sub-web00${robot}`, 'ses-01', 'head', 'exposure-office_run-01.csv');
  expect(readFileSync(head, 'utf8')).toMatch(/,moved,Inline_\w+,/); // found by replaying the scene
  // The answers are read; one old and one new object are too few for a test, which is said by the exit status, too.
  expect(() => selectiveRenderer('experiment', 'analyse', responses)).toThrow('of the area office cannot be tested');
}, 300_000);
