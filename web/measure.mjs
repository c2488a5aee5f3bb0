// Measures the page of exported scenes in Chromium: until the first picture, and frames while walking a path.
//
//   node measure.mjs [--runs N] [--size WxH] [--path FILE.csv] [--args "CHROMIUM'S OPTIONS"] FOLDER...
//
// FOLDER is what `selective-renderer export SCENE --to web FOLDER` has written. For each, a line of a table: seconds
// from the last byte that the first picture needs until it is there, seconds of processor time until then (of the page,
// and of the drawing, which is a process of its own), frames per second along the path with every frame waited for.
// Medians of N runs (3), each in a new Chromium that draws by software unless --args says otherwise. Run nothing else
// meanwhile. Compare with `selective-renderer run SCENE --benchmark`, docs/performance.md.
import { createReadStream, existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import path from 'node:path';
import { parseArgs } from 'node:util';
import puppeteer from 'puppeteer-core';

const SOFTWARE = '--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist';
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    runs: { type: 'string', default: '3' },
    size: { type: 'string', default: '1024x768' },
    path: { type: 'string' },
    args: { type: 'string', default: SOFTWARE },
  },
});
const [width, height] = values.size.split('x').map(Number);
if (positionals.length === 0 || !(width > 0 && height > 0) || !(Number(values.runs) > 0)) {
  console.error('usage: node measure.mjs [--runs N] [--size WxH] [--path FILE.csv] [--args OPTIONS] FOLDER...');
  process.exit(2);
}
const rows = values.path === undefined
  ? []
  : readFileSync(values.path, 'utf8').trim().split('\n').slice(1).map((line) => line.split(',').map(Number));

const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json' };

function serve(folder) {
  return new Promise((ready) => {
    const server = createServer((asked, answer) => {
      const name = path.normalize(decodeURIComponent(new URL(asked.url, 'http://host').pathname));
      const file = path.join(folder, name.endsWith(path.sep) ? `${name}index.html` : name);
      if (!existsSync(file)) {
        answer.writeHead(404).end();
        return;
      }
      answer.writeHead(200, { 'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream' });
      createReadStream(file).pipe(answer);
    });
    server.listen(0, '127.0.0.1', () => { ready(server); });
  });
}

async function processorTime(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const sum = (type) => processInfo.filter((each) => each.type === type).reduce((all, each) => all + each.cpuTime, 0);
  return { page: sum('renderer'), drawing: sum('GPU') };
}

/** Runs in the page: notes when it has drawn its first picture, and lets it rest then. */
function firstPicture() {
  let shown;
  Object.defineProperty(window, 'selectiveRenderer', {
    get: () => shown,
    set: (value) => {
      shown = value;
      // The frame is drawn when its pixels can be read.
      const gl = document.querySelector('x3d-canvas').shadowRoot.querySelector('canvas').getContext('webgl2');
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      window.pictureAt = performance.now();
      value.walker.walks = false;
      value.world.browser.endUpdate();
    },
  });
}

async function measure(folder) {
  const server = await serve(folder);
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    protocolTimeout: 600_000,
    args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', ...values.args.split(' ').filter(Boolean)],
  });
  try {
    const page = await browser.newPage();
    await page.setViewport({ width, height });
    const session = await browser.target().createCDPSession();
    const before = await processorTime(session);
    await page.evaluateOnNewDocument(firstPicture);
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForFunction(() => window.pictureAt ?? document.querySelector('#status.failed'), { timeout: 500_000 });
    const picture = await page.evaluate(() => {
      const files = performance.getEntriesByType('resource').map((entry) => entry.responseEnd);
      return (window.pictureAt - Math.max(...files)) / 1000;
    });
    const after = await processorTime(session);
    const frames = rows.length === 0 ? undefined : await page.evaluate(async (along) => {
      const { world } = window.selectiveRenderer;
      world.browser.beginUpdate();
      while (await world.loadNext()); // what is read meanwhile is no frame time
      const gl = document.querySelector('x3d-canvas').shadowRoot.querySelector('canvas').getContext('webgl2');
      const began = performance.now();
      for (const [, x, y, z, yaw, pitch, roll] of along) {
        world.setPose({ x, y, z, yaw, pitch, roll });
        await world.browser.nextFrame();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      }
      return (1000 * along.length) / (performance.now() - began);
    }, rows);
    return { picture, page: after.page - before.page, drawing: after.drawing - before.drawing, frames };
  } finally {
    await browser.close();
    server.closeAllConnections();
    server.close();
  }
}

function median(runs, key) {
  const sorted = runs.map((run) => run[key]).sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

console.log('| scene | first picture after its bytes | processor time: page | drawing | frames per second |');
console.log('| --- | --- | --- | --- | --- |');
for (const folder of positionals) {
  const runs = [];
  for (let run = 0; run < Number(values.runs); run++) {
    runs.push(await measure(path.resolve(folder)));
  }
  const cells = ['picture', 'page', 'drawing'].map((key) => `${median(runs, key).toFixed(1)} s`);
  const frames = median(runs, 'frames');
  console.log(`| ${path.basename(folder)} | ${cells.join(' | ')} | ${frames === undefined ? '' : frames.toFixed(1)} |`);
}
