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
    await page.waitForSelector('#headset:not([hidden])');
    await page.click('#headset');
    await page.waitForFunction(() => window.selectiveRenderer?.headset?.worn, { timeout: 60_000 });
    await frames(page);
    const at = await pose();
    expect(at.x).toBeCloseTo(START.x, 2);
    expect(at.z).toBeCloseTo(START.z, 2);
    expect(at.yaw).toBeCloseTo(START.yaw, 1);
    expect(at.pitch).toBeCloseTo(0, 1);
    await picture('both-eyes');
  }, 90_000);

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
  }, 60_000);

  it('gives the page back when the session ends', async () => {
    await page.evaluate(() => window.selectiveRenderer?.headset?.leave());
    await page.waitForFunction(() => !window.quest?.activeSession);
    await frames(page);
    const at = await pose();
    expect(at.x).toBeCloseTo(START.x, 2);
    expect(at.z).toBeCloseTo(START.z, 2);
    expect(at.pitch).toBeCloseTo(0, 1);
    expect(await page.$eval('#bar', (bar) => getComputedStyle(bar).display)).not.toBe('none');
    await page.click('#headset');
    await page.waitForFunction(() => window.selectiveRenderer?.headset?.worn, { timeout: 60_000 });
    await page.evaluate(() => window.selectiveRenderer?.headset?.leave());
    await picture('page-again');
    expect(errors).toEqual([]);
  }, 90_000);
});
