import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Browser } from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Browser as X3dBrowser, FieldNode, Namespace } from '../src/scene/xite.js';
import { ROOT, launch, selectiveRenderer, serve, temporary } from './chromium.js';

/** Frames per second of the path's time. */
const RATE = 4;
const SCENE = 'scenes/trashcan.x3d';
const PATH = 'scenes/paths/desk-visit.csv';

let browser: Browser;
const { folder, remove } = temporary();

beforeAll(async () => {
  browser = await launch();
  // A page of somebody else's, which knows X_ITE only.
  cpSync(path.join(ROOT, 'web', 'node_modules', 'x_ite', 'dist'), path.join(folder, 'x_ite'), {
    recursive: true,
    filter: (file) => !/\.(zip|mjs|d\.ts|map)$|x_ite\.js$/.test(file),
  });
  writeFileSync(
    path.join(folder, 'index.html'),
    '<!DOCTYPE html><link rel="icon" href="data:,"><script src="x_ite/x_ite.min.js"></script>'
      + '<x3d-canvas style="width: 100vw; height: 100vh"></x3d-canvas>',
  );
}, 60_000);

afterAll(async () => {
  await browser.close();
  remove();
});

interface Change {
  t: number;
  object: string;
  choice: number;
}

/** Returns the places of the path at each frame: x, y, z. */
function places(): number[][] {
  const rows = readFileSync(path.join(ROOT, PATH), 'utf8').trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  const last = rows.at(-1)?.[0] ?? 0;
  return Array.from({ length: last * RATE + 1 }, (_, frame) => {
    const t = frame / RATE;
    const next = Math.max(1, rows.findIndex((row) => (row[0] ?? 0) >= t));
    const [from = [], to = []] = rows.slice(next - 1, next + 1);
    const share = (t - (from[0] ?? 0)) / ((to[0] ?? 0) - (from[0] ?? 0));
    return [1, 2, 3].map((i) => (from[i] ?? 0) + ((to[i] ?? 0) - (from[i] ?? 0)) * share);
  });
}

/** Returns what `simulate` switches in the scene along the path. */
function simulated(): Change[] {
  const lines = selectiveRenderer('simulate', SCENE, '--path', PATH, '--rate', String(RATE), '--format', 'json');
  return lines.trim().split('\n').flatMap((line) => {
    const { t, event, switch: object = '', to = -1 } = JSON.parse(line) as { t: number; event: string; switch?: string; to?: number };
    return event === 'switch' ? [{ t, object, choice: to }] : [];
  });
}

describe('a copy for other browsers', () => {
  it.each(['x3d', 'x3dv', 'json'])('is shown by X_ITE as %s, and its Script switches as this program does', async (encoding) => {
    selectiveRenderer('export', SCENE, '--to', encoding, path.join(folder, encoding));
    const server = await serve(folder);
    const page = await browser.newPage();
    const errors: string[] = [];
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('response', (response) => {
      if (response.status() >= 400) {
        errors.push(`${response.status()} ${response.url()}`);
      }
    });
    await page.setViewport({ width: 320, height: 240 });
    await page.goto(server.url);
    const file = `${encoding}/trashcan.${encoding}`;
    await page.waitForFunction(() => (window as { X3D?: unknown }).X3D);
    await page.evaluate(async (url) => {
      const { X3D } = window as unknown as { X3D: Namespace };
      const x3d = X3D.getBrowser(document.querySelector('x3d-canvas') as never) as unknown as X3dBrowser;
      x3d.setBrowserOption('SplashScreen', false);
      await x3d.loadURL(new X3D.MFString(url));
      await x3d.nextFrame();
      await x3d.nextFrame();
    }, file);

    // The room is there: a picture of nothing has one colour.
    const picture = await page.screenshot({ encoding: 'base64' });
    expect(await page.evaluate(colours, picture)).toBeGreaterThan(100);

    const changes = await page.evaluate(
      async (along, rate) => {
        const { X3D } = window as unknown as { X3D: Namespace };
        const x3d = X3D.getBrowser(document.querySelector('x3d-canvas') as never) as unknown as X3dBrowser;
        x3d.setBrowserOption('ContentScale', 0.1); // what is seen is not looked at any more
        const scene = x3d.currentScene;
        const still = scene.createNode('NavigationInfo') as unknown as FieldNode;
        still.type = new X3D.MFString('NONE');
        const viewpoint = scene.createNode('Viewpoint') as unknown as FieldNode;
        scene.addRootNode(still);
        scene.addRootNode(viewpoint);
        still.set_bind = true;
        viewpoint.set_bind = true;
        const seen: { t: number; object: string; choice: number }[] = [];
        let t = 0;
        const object = 'Switch_TrashCan';
        (scene.getNamedNode(object) as FieldNode).addFieldCallback({}, 'whichChoice', (choice) => {
          seen.push({ t, object, choice: Number(choice) });
        });
        for (const [frame, [x = 0, y = 0, z = 0]] of along.entries()) {
          t = frame / rate;
          viewpoint.position = new X3D.SFVec3f(x, y, z);
          await x3d.nextFrame();
          await x3d.nextFrame();
        }
        return seen;
      },
      places(),
      RATE,
    );
    expect(changes.length).toBeGreaterThan(0);
    expect(changes).toEqual(simulated());
    expect(errors).toEqual([]);
    await page.close();
    server.close();
  });
});

/** Runs in the page: returns how many colours a picture has. */
async function colours(png: string): Promise<number> {
  const bytes = await (await fetch(`data:image/png;base64,${png}`)).blob();
  const image = await createImageBitmap(bytes);
  const drawing = new OffscreenCanvas(image.width, image.height).getContext('2d');
  drawing?.drawImage(image, 0, 0);
  const pixels = drawing?.getImageData(0, 0, image.width, image.height).data ?? new Uint8ClampedArray();
  return new Set(new Uint32Array(pixels.buffer)).size;
}
