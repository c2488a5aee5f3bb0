import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from 'puppeteer-core';
import { expect, it } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { frames, wear } from './quest.js';
import { ReferenceReceiver, fillForm, officeStudy, press, set, told } from './study-robot.js';

/** Seconds of the exposure: a machine without a graphics card draws few frames in them. */
const SECONDS = 12;

const OPTIONS = [
  { value: 'bin', text: 'a trash can' },
  { value: 'sofa', text: 'a sofa' },
  { value: 'bed', text: 'a bed' },
];

/** Writes a study of one exposure and of questions that a panel asks: a choice with pictures' names, and a scale. */
function study(folder: string): string {
  const file = officeStudy(folder);
  const json = JSON.parse(readFileSync(file, 'utf8')) as { conditions: string[]; areas: { seconds: number }[]; questionnaires: unknown[] };
  json.conditions = ['selective'];
  json.areas.forEach((area) => { area.seconds = SECONDS; });
  json.questionnaires = [{ file: 'closing.json' }];
  writeFileSync(file, JSON.stringify(json));
  writeFileSync(
    path.join(folder, 'closing.json'),
    JSON.stringify({
      name: 'closing',
      pages: [{
        title: 'What you saw',
        questions: [
          { id: 'seen', kind: 'single', text: 'What stood beside the desk?', options: OPTIONS },
          { id: 'sure', kind: 'scale', text: 'How sure are you?', from: 1, to: 5, least: 'not at all', most: 'entirely' },
        ],
      }],
    }),
  );
  return file;
}

/** Points the right controller at something of the panel, and pulls its trigger. */
async function pull(page: Page, name: string, share = 0.5): Promise<void> {
  await page.waitForFunction(
    (wanted) => window.studyPanel?.()?.some((target) => target.name === wanted), { timeout: 120_000 }, name);
  await page.evaluate((wanted, part) => {
    const target = window.studyPanel?.()?.find((each) => each.name === wanted);
    const { quest } = window;
    const hand = quest?.controllers.right;
    if (!target || !quest || !hand) {
      throw new Error(`no ${wanted}`);
    }
    // The panel is 1.6 m wide and as far away, before eyes that look along -Z.
    const x = ((target.x + part * target.width) / 1280 - 0.5) * 1.6;
    const y = (0.5 - (target.y + target.height / 2) / 960) * 1.2;
    hand.position.set(quest.position.x + x, quest.position.y + y, quest.position.z);
    hand.quaternion.set(0, 0, 0, 1);
  }, name, share);
  await frames(page);
  await page.evaluate(() => window.quest?.controllers.right?.updateButtonValue('trigger', 1));
  await frames(page);
  await page.evaluate(() => window.quest?.controllers.right?.updateButtonValue('trigger', 0));
  await frames(page);
}

async function picture(page: Page, name: string): Promise<void> {
  if (process.env.PICTURES) {
    writeFileSync(path.join(process.env.PICTURES, `${name}.png`), await page.screenshot());
  }
}

it('is taken part in with a headset: the head enters an area, the object changes, a panel asks', async () => {
  const { folder, remove } = temporary();
  const site = path.join(folder, 'site');
  selectiveRenderer('experiment', 'export', study(folder), '--to', 'web', site);
  const server = await serve(site);
  const receiver = await ReferenceReceiver.start(folder, new URL(server.url).origin);
  set(site, { receiver: `${receiver.url}/`, headset: 'offer', fullScreen: false, minWidth: 300, minHeight: 200, minRefresh: 0, minFrameRate: 0 });
  const browser = await launch();
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await wear(page);
  await page.setViewport({ width: 640, height: 320 });
  await page.goto(`${server.url}?lang=en`);
  await fillForm(page, 0);
  await press(page, 'In the headset');
  await pull(page, 'Begin');
  await picture(page, 'study-exposure');
  // From the office's viewpoint to the desk, in the room of the headset.
  await page.evaluate(() => {
    const yaw = (-151.133 * Math.PI) / 180;
    const [dx, dz] = [4.4 - 3.6, -0.35 + 2.3];
    window.quest?.position.set(dx * Math.cos(yaw) - dz * Math.sin(yaw), 1.6, dx * Math.sin(yaw) + dz * Math.cos(yaw));
  });
  await page.waitForFunction(() => window.studyPanel?.(), { timeout: 240_000 });
  await frames(page, 6);
  await picture(page, 'study-panel');
  await pull(page, 'a trash can');
  await pull(page, 'Continue');
  await pull(page, '4');
  await picture(page, 'study-scale');
  await pull(page, 'Continue');
  await told(page, 'All is done.');
  expect(await page.evaluate(() => !window.quest?.activeSession)).toBe(true);
  expect(errors).toEqual([]);

  const [records = []] = receiver.written().records;
  expect(records.map(({ step, ...record }) => [step, (record as { display?: string }).display])).toEqual([
    ['form', undefined],
    ['exposure-office', 'webxr'],
    ['closing', 'webxr'],
  ]);
  const [, exposure, closing] = records;
  const { log } = exposure as unknown as { log: { rows: number[][]; events: { event: string; node: string }[] } };
  expect(log.rows.length).toBeGreaterThan(3);
  const [first, last] = [log.rows[0] ?? [], log.rows.at(-1) ?? []];
  expect(first[1]).toBeCloseTo(3.6, 1);
  expect(last[1]).toBeGreaterThan(4.3); // the trigger that pressed Begin may walk a hand's breadth
  expect(last[1]).toBeLessThan(4.55);
  expect(log.events).toContainEqual(expect.objectContaining({ event: 'enter', node: 'DeskProx' }));
  expect(log.events).toContainEqual(expect.objectContaining({ event: 'switch', node: 'Switch_TrashCan', choice: 0 }));
  expect(closing?.answers?.map(({ question, value }) => [question, value])).toEqual([['seen', 'bin'], ['sure', '4']]);
  await browser.close();
  server.close();
  await receiver.stop();
  remove();
}, 600_000);
