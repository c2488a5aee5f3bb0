import { expect, it } from 'vitest';
import { launch, selectiveRenderer, serve, temporary } from './chromium.js';

/** The picture of docs/export.md, which docs/pictures.sh takes; without a place for it nothing is taken. */
it.skipIf(!process.env.PICTURE)('is taken of the kitchen', async () => {
  const { folder, remove } = temporary();
  selectiveRenderer('export', 'scenes/apartment.x3d', '--to', 'web', folder);
  const server = await serve(folder);
  const browser = await launch();
  const page = await browser.newPage();
  await page.setViewport({ width: 1024, height: 700 });
  await page.goto(`${server.url}?lang=en`);
  await page.waitForFunction(() => window.selectiveRenderer, { timeout: 240_000 });
  await page.evaluate(async () => {
    for (let i = 0; i < 3; i++) {
      await window.selectiveRenderer?.world.browser.nextFrame();
    }
  });
  const picture = await page.screenshot({ path: (process.env.PICTURE ?? '') });
  expect(picture.length).toBeGreaterThan(100_000);
  await browser.close();
  server.close();
  remove();
});
