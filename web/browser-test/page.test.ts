import { readFileSync, rmSync, cpSync } from 'node:fs';
import path from 'node:path';
import type { Browser, Page } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Pose } from '../src/scene/pose.js';
import { ROOT, launch, selectiveRenderer, serve, temporary } from './chromium.js';

/** Frames per second of the path's time: events fall into the same frames in both browsers. */
const RATE = 4;

let browser: Browser;
const { folder, remove } = temporary();
const opened: (() => void)[] = [];

beforeAll(async () => {
  browser = await launch();
}, 60_000);

afterAll(async () => {
  await browser.close();
  opened.forEach((close) => { close(); });
  remove();
});

/** Exports a scene once. */
function exported(scene: string): string {
  const into = path.join(folder, path.basename(scene, '.x3d'));
  selectiveRenderer('export', scene, '--to', 'web', into);
  return into;
}

async function open(site: string, query = '', width = 320, height = 240): Promise<{ page: Page; errors: string[] }> {
  const server = await serve(site);
  opened.push(server.close);
  const page = await browser.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('response', (response) => {
    if (response.status() >= 400) {
      errors.push(`${response.status()} ${response.url()}`);
    }
  });
  await page.setViewport({ width, height, hasTouch: true });
  await page.goto(server.url + query);
  await page.waitForFunction(() => window.selectiveRenderer ?? document.querySelector('#status.failed'), {
    timeout: 240_000,
  });
  return { page, errors };
}

interface Row {
  t: number;
  event: string;
  node: string;
  choice?: number;
}

/** Walks a path frame by frame; returns what happens, and when. */
async function walk(page: Page, file: string): Promise<Row[]> {
  const rows = readFileSync(path.join(ROOT, file), 'utf8').trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  return page.evaluate(
    async (path, rate) => {
      if (!window.selectiveRenderer) {
        throw new Error('no scene');
      }
      const { world, walker } = window.selectiveRenderer;
      walker.walks = false;
      world.browser.setBrowserOption('ContentScale', 0.1); // what is seen is not looked at here
      const seen: Row[] = [];
      let t = 0;
      const stop = world.listen((event) => {
        seen.push(
          event.kind === 'switch'
            ? { t, event: event.kind, node: event.object, choice: event.choice }
            : { t, event: event.kind, node: event.area },
        );
      });
      const last = path.at(-1)?.[0] ?? 0;
      for (let frame = 0; frame / rate <= last; frame++) {
        t = frame / rate;
        const next = path.findIndex((row) => (row[0] ?? 0) >= t);
        const to = path[next] ?? [];
        const from = path[Math.max(0, next - 1)] ?? to;
        const share = next === 0 ? 1 : (t - (from[0] ?? 0)) / ((to[0] ?? 0) - (from[0] ?? 0));
        const [x = 0, y = 0, z = 0, yaw = 0, pitch = 0, roll = 0] = from.slice(1).map((value, i) => value + ((to[i + 1] ?? 0) - value) * share);
        world.setPose({ x, y, z, yaw, pitch, roll });
        await world.browser.nextFrame();
        await world.browser.nextFrame();
      }
      stop();
      return seen;
    },
    rows,
    RATE,
  );
}

/** Returns what happens on the same path in this program. */
function simulated(scene: string, file: string): Row[] {
  const lines = selectiveRenderer('simulate', scene, '--path', file, '--rate', String(RATE), '--format', 'json');
  return lines.trim().split('\n').flatMap((line) => {
    const { t, event, sensor = '', switch: node = '', to = -1 } = JSON.parse(line) as Told;
    if (event === 'switch') {
      return [{ t, event, node, choice: to }];
    }
    return event === 'enter' || event === 'exit' ? [{ t, event, node: sensor }] : [];
  });
}

/** A line of what the command simulate prints. */
interface Told {
  readonly t: number;
  readonly event: string;
  readonly sensor?: string;
  readonly switch?: string;
  readonly to?: number;
}

/** What X_ITE has of a viewpoint inside. */
interface Viewed {
  _positionOffset: unknown;
  readonly timeSensor: { readonly _isActive: { getValue(): boolean } };
}

describe('the page of the trash can', () => {
  let site: string;
  beforeAll(() => {
    site = exported('scenes/trashcan.x3d');
  }, 60_000);

  it('has the time line of this program along a path', async () => {
    const { page, errors } = await open(site);
    expect(await walk(page, 'scenes/paths/desk-visit.csv')).toEqual(
      simulated('scenes/trashcan.x3d', 'scenes/paths/desk-visit.csv'),
    );
    expect(await page.title()).toBe('Trash can');
    expect(errors).toEqual([]);
    await page.close();
  });

  it('takes back what the viewer of X_ITE itself moved the eyes by', async () => {
    const { page } = await open(site);
    const heights = await page.evaluate(async () => {
      const shown = window.selectiveRenderer;
      if (!shown) {
        throw new Error('no scene');
      }
      const { world, walker } = shown;
      walker.walks = false;
      world.browser.setBrowserOption('ContentScale', 0.1);
      const placed = world.pose();
      const inside = (world.browser.activeViewpoint as unknown as { getValue(): Viewed }).getValue();
      while (inside.timeSensor._isActive.getValue()) {
        await world.browser.nextFrame(); // X_ITE is still on the way to the viewpoint
      }
      // As X_ITE does when it sets the eyes on the floor, for which they must be a centimetre too low.
      inside._positionOffset = new world.x3d.SFVec3f(0, 0.0147, 0);
      await world.nextFrame();
      await world.nextFrame();
      world.setPose({ ...placed, x: placed.x + 0.1 });
      await world.nextFrame();
      await world.nextFrame();
      return { placed: placed.y, after: world.pose().y };
    });
    expect(heights.after).toBeCloseTo(heights.placed, 4);
    await page.close();
  }, 300_000);

  it('loads the version that nobody sees after the first picture', async () => {
    const server = await serve(site);
    opened.push(server.close);
    const page = await browser.newPage();
    // Notes what has come when the first picture is there.
    await page.evaluateOnNewDocument(() => {
      let shown: unknown;
      Object.defineProperty(window, 'selectiveRenderer', {
        get: () => shown,
        set: (value) => {
          shown = value;
          (window as { first?: string[] }).first = performance.getEntriesByType('resource').map((entry) => entry.name);
        },
      });
    });
    await page.goto(server.url);
    await page.waitForFunction(() => (window as { first?: string[] }).first, { timeout: 240_000 });
    const first = await page.evaluate(() => (window as { first?: string[] }).first?.map((name) => name.split('/').pop()));
    expect(first).toContain('trashCan_v2.x3dz');
    expect(first).not.toContain('trashCan_v1.x3dz');
    await page.waitForFunction(
      () => performance.getEntriesByType('resource').some((entry) => entry.name.endsWith('trashCan_v1.x3dz')),
      { timeout: 240_000 },
    );
    await page.close();
  });

  it('shows all objects with all polygons when its address says so, and follows the list of conditions', async () => {
    const { page } = await open(site, '?condition=high&lang=el');
    const choice = (): Promise<number | undefined> =>
      page.evaluate(async () => {
        const world = window.selectiveRenderer?.world;
        await world?.browser.nextFrame();
        await world?.browser.nextFrame();
        return world?.choice('Switch_TrashCan');
      });
    expect(await choice()).toBe(0);
    expect(await page.$eval('#condition', (list) => (list as HTMLSelectElement).selectedOptions[0]?.text)).toBe(
      'Όλα με όλα τα πολύγωνα',
    );
    await page.select('#condition', 'high-low');
    expect(await choice()).toBe(0); // the trash can is unexpected at the desk
    await page.select('#condition', 'selective');
    expect(await choice()).toBe(1);
    await page.close();
  });

  it('is walked by keys, mouse and touch', async () => {
    const { page } = await open(site);
    const pose = (): Promise<Pose> => page.evaluate(() => window.selectiveRenderer?.world.pose() as never);
    const held = async (action: () => Promise<void>, end: () => Promise<void>): Promise<[Pose, Pose]> => {
      const before = await pose();
      await action();
      await page.evaluate(async () => {
        for (let i = 0; i < 5; i++) {
          await window.selectiveRenderer?.world.browser.nextFrame();
        }
      });
      await end();
      return [before, await pose()];
    };
    const ahead = ([from, to]: [Pose, Pose]): number => {
      const yaw = (from.yaw * Math.PI) / 180;
      return -(to.x - from.x) * Math.sin(yaw) - (to.z - from.z) * Math.cos(yaw);
    };

    expect(ahead(await held(() => page.keyboard.down('KeyW'), () => page.keyboard.up('KeyW')))).toBeGreaterThan(0.02);
    const [from, to] = await held(() => page.keyboard.down('ArrowLeft'), () => page.keyboard.up('ArrowLeft'));
    expect(turn(from, to)).toBeGreaterThan(1);

    await page.mouse.move(200, 60);
    await page.mouse.down();
    const [, dragged] = await held(() => page.mouse.move(240, 60), () => page.mouse.up());
    expect(turn(to, dragged)).toBeCloseTo(-10, 0);

    const finger = await page.touchscreen.touchStart(60, 100);
    expect(ahead(await held(() => finger.move(60, 50), () => finger.end()))).toBeGreaterThan(0.02);
    await page.close();
  });

  it('measures walls and floor from where the viewer is now', async () => {
    const { page } = await open(site);
    const near = (dx: number, dy: number): Promise<{ floor: number; wall: number }> =>
      page.evaluate(async (x, y) => {
        const world = window.selectiveRenderer?.world;
        if (!world) {
          throw new Error('no scene');
        }
        const pose = world.pose();
        world.setPose({ ...pose, x: pose.x + x, y: pose.y + y });
        await world.browser.nextFrame();
        await world.browser.nextFrame();
        const steps = Array.from({ length: 60 }, (_, i) => (i + 1) / 20);
        const wall = steps.find((step) => Math.abs(world.free(-step, 0).x + step) > 1e-3) ?? NaN;
        return { floor: world.floor() ?? NaN, wall };
      }, dx, dy);
    await page.evaluate(() => {
      if (window.selectiveRenderer) {
        window.selectiveRenderer.walker.walks = false;
      }
    });
    const from = await near(0, 0);
    const to = await near(0.5, 0.4);
    expect(to.wall - from.wall).toBeCloseTo(0.5, 1);
    expect(to.floor - from.floor).toBeCloseTo(0.4, 1);
    await page.close();
  });

  it('tells frames, areas and versions where they are asked for', async () => {
    const { page } = await open(site, '?details=1', 800, 600);
    await page.waitForFunction(() => document.getElementById('details')?.textContent.includes('Switch_TrashCan: 1'));
    await page.keyboard.press('F1');
    expect(await page.$eval('#details', (details) => (details as HTMLElement).hidden)).toBe(true);
    await page.close();
  });

  it('writes how to walk above what is touched, on the width of a phone', async () => {
    const { page } = await open(site, '', 390, 844);
    const [hint, first] = await page.evaluate(() =>
      ['#hint', '#condition'].map((part) => document.querySelector(part)?.getBoundingClientRect().toJSON() as DOMRect));
    expect(hint?.height).toBeGreaterThan(0);
    expect(hint?.bottom).toBeLessThanOrEqual(first?.top ?? 0);
    await page.close();
  });

  it('says in a sentence which file it lacks', async () => {
    const torn = path.join(folder, 'torn');
    cpSync(site, torn, { recursive: true });
    rmSync(path.join(torn, 'scene', 'trashcan.x3dz'));
    const { page } = await open(torn);
    const text = await page.$eval('#status', (status) => status.textContent);
    expect(text).toMatch(/^The scene cannot be shown\. scene\/trashcan\.x3dz cannot be loaded/);
    await page.close();
  });
});

/** Areas that overlap; and all rooms, which takes a minute and is asked for. */
const TOURS: [scene: string, path: string][] = [['scenes/overlap.x3d', 'scenes/paths/overlap-visit.csv']];
if (process.env.ALL_PATHS) {
  TOURS.push(['scenes/apartment.x3d', 'scenes/paths/apartment-tour.csv']);
}

describe('the page of another scene', () => {
  it.each(TOURS)('%s has the time line of this program along %s', async (scene, file) => {
    const { page, errors } = await open(exported(scene));
    const told = simulated(scene, file);
    expect(told.length).toBeGreaterThan(4);
    expect(await walk(page, file)).toEqual(told);
    expect(errors).toEqual([]);
    await page.close();
  }, 900_000);
});

function turn(from: Pose, to: Pose): number {
  return ((to.yaw - from.yaw + 540) % 360) - 180;
}
