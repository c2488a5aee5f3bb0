import { writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Pose } from '../src/scene/pose.js';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';
import { frames, wear } from './quest.js';

/** What is seen at the beginning of the path desk-visit.csv, and on its way in the area of the desk. */
const START = { x: 3.6, z: -2.3, yaw: -151.133 };
const DESK = { x: 4.4, z: -0.35 };

let browser: Browser;
let page: Page;
let server: { url: string; close: () => void };
const errors: string[] = [];
const { folder, remove } = temporary();

beforeAll(async () => {
  selectiveRenderer('export', 'scenes/trashcan.x3d', '--to', 'web', path.join(folder, 'trashcan'));
  server = await serve(path.join(folder, 'trashcan'));
  browser = await launch();
  page = await browser.newPage();
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') {
      errors.push(message.text());
    }
  });
  await wear(page);
  await page.setViewport({ width: 640, height: 320 });
  await page.goto(server.url);
  await page.waitForFunction(() => window.selectiveRenderer ?? document.querySelector('#status.failed'), { timeout: 240_000 });
}, 300_000);

afterAll(async () => {
  await browser.close();
  server.close();
  remove();
});

function pose(): Promise<Pose> {
  return page.evaluate(() => window.selectiveRenderer?.world.pose() as never);
}

function state(): Promise<{ areas: string[]; choice: number }> {
  return page.evaluate(() => {
    const world = window.selectiveRenderer?.world;
    return { areas: world?.entered() ?? [], choice: world?.choice('Switch_TrashCan') ?? NaN };
  });
}

/** Moves the head in the room of the headset: metres from where it began; degrees. */
async function head(x: number, y: number, z: number, yaw = 0): Promise<void> {
  await page.evaluate((at, turn) => {
    window.quest?.position.set(...at);
    window.quest?.quaternion.set(0, Math.sin(turn / 2), 0, Math.cos(turn / 2));
  }, [x, y, z] as [number, number, number], (yaw * Math.PI) / 180);
  await frames(page);
}

/** Returns the way in the room of the headset to a place of the scene, for who began to look as the viewpoint does. */
function way(to: { x: number; z: number }): [x: number, z: number] {
  const yaw = (START.yaw * Math.PI) / 180;
  const [dx, dz] = [to.x - START.x, to.z - START.z];
  return [dx * Math.cos(yaw) - dz * Math.sin(yaw), dx * Math.sin(yaw) + dz * Math.cos(yaw)];
}

/** Keeps the picture where PICTURES names a folder, for people to look at. */
async function picture(name: string): Promise<void> {
  if (process.env.PICTURES) {
    writeFileSync(path.join(process.env.PICTURES, `${name}.png`), await page.screenshot());
  }
}

describe('the page on an emulated Quest 3', () => {
  it('begins a session where the viewpoint is, with a picture for each eye', async () => {
    await page.waitForSelector('#headset:not([hidden])', { timeout: 120_000 });
    await page.click('#headset');
    await page.waitForFunction(() => window.selectiveRenderer?.headset?.worn, { timeout: 120_000 });
    await frames(page);
    const at = await pose();
    expect(at.x).toBeCloseTo(START.x, 2);
    expect(at.z).toBeCloseTo(START.z, 2);
    expect(at.yaw).toBeCloseTo(START.yaw, 1);
    expect(at.pitch).toBeCloseTo(0, 1);
    await picture('both-eyes');
  }, 180_000);

  it('enters the area that the head walks into, and the object changes', async () => {
    expect(await state()).toEqual({ areas: [], choice: 1 });
    const [x, z] = way(DESK);
    await head(x, 1.6, z);
    const at = await pose();
    expect(at.x).toBeCloseTo(DESK.x, 2);
    expect(at.z).toBeCloseTo(DESK.z, 2);
    expect(await state()).toEqual({ areas: ['DeskProx'], choice: 0 });
    await picture('at-the-desk');
    await head(0, 1.6, 0);
    expect(await state()).toEqual({ areas: [], choice: 1 });
  }, 180_000);

  it('walks where the head looks by the left stick, up to the walls, and turns by the right one in steps', async () => {
    await page.evaluate(() => {
      const walker = window.selectiveRenderer?.walker;
      walker?.move(); // the time of the next step begins now
      window.quest?.controllers.left?.updateAxes('thumbstick', 0, -1);
    });
    const from = await pose();
    await frames(page, 5);
    const to = await pose();
    const yaw = (from.yaw * Math.PI) / 180;
    const ahead = -(to.x - from.x) * Math.sin(yaw) - (to.z - from.z) * Math.cos(yaw);
    const aside = (to.x - from.x) * Math.cos(yaw) - (to.z - from.z) * Math.sin(yaw);
    expect(ahead).toBeGreaterThan(0.05);
    expect(aside).toBeCloseTo(0, 3);
    expect(to.y).toBeCloseTo(from.y, 1); // the eyes settle on the floor by a centimetre

    await page.evaluate(() => window.quest?.controllers.left?.updateAxes('thumbstick', 0, 0));
    await frames(page, 2);
    const stood = await pose();
    await page.evaluate(() => window.quest?.controllers.right?.updateAxes('thumbstick', 1, 0));
    await frames(page, 4);
    const turned = await pose();
    expect(((turned.yaw - stood.yaw + 540) % 360) - 180).toBeCloseTo(-30, 1); // once, however long the stick is held
    expect(turned.x).toBeCloseTo(stood.x, 1); // about the head, not about the room
    expect(turned.z).toBeCloseTo(stood.z, 1);
    await page.evaluate(() => window.quest?.controllers.right?.updateAxes('thumbstick', 0, 0));
    await frames(page);
  }, 180_000);

  it('shows the scene from the height of the head above the floor', async () => {
    const floor = (): Promise<number> => page.evaluate(() => window.selectiveRenderer?.world.floor() ?? NaN);
    const before = await pose();
    expect(before.y).toBeCloseTo(-0.246 - 1.7 + 1.6, 1); // the floor is 1.7 m below the viewpoint
    expect(await floor()).toBeCloseTo(1.7, 1);
    await head(0, 1.2, 0);
    expect((await pose()).y).toBeCloseTo(before.y - 0.4, 2);
    await head(0, 1.6, 0);
  }, 180_000);

  it('gives the page back when the session ends', async () => {
    const before = await pose();
    await page.evaluate(() => window.selectiveRenderer?.headset?.leave());
    await page.waitForFunction(() => !window.quest?.activeSession);
    await frames(page);
    const at = await pose();
    expect(at.x).toBeCloseTo(before.x, 2);
    expect(at.z).toBeCloseTo(before.z, 2);
    expect(at.y).toBeCloseTo(before.y + 0.1, 2); // the walker's eyes are 1.7 m above the floor
    expect(await page.$eval('#bar', (bar) => getComputedStyle(bar).display)).not.toBe('none');
    await page.click('#headset');
    await page.waitForFunction(() => window.selectiveRenderer?.headset?.worn, { timeout: 120_000 });
    await page.evaluate(() => window.selectiveRenderer?.headset?.leave());
    await picture('page-again');
    expect(errors).toEqual([]);
  }, 180_000);
});
