// Measures the page of exported scenes in Chromium: until the first picture, and frames along a path.
//
//   node measure.mjs [--runs N] [--size WxH] [--path FILE.csv [--frames N]] [--samples 0|4] [--args "CHROMIUM'S OPTIONS"]
//       FOLDER...
//
// FOLDER is what `selective-renderer export SCENE --to web FOLDER` has written. For each, a line of a table: seconds
// from the last byte that the first picture needs until the page has read, set out and handed over its first picture,
// and from then until that is drawn; seconds of processor time until then (of the page, and of the drawing, which is a
// process of its own); frames per second at N places (20), the same distance of time apart, of the path, with every
// frame waited for, and milliseconds of processor time of such a frame. Medians of N runs (3), each in a new Chromium
// that draws by software unless --args says otherwise; X_ITE smooths edges by 4 samples unless --samples says 0. Run
// nothing else meanwhile: beside other work only processor times tell something. Compare with
// `selective-renderer run SCENE --offscreen --path FILE.csv --samples 4 --stats FILE.json`, docs/performance.md.
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
    frames: { type: 'string', default: '20' },
    samples: { type: 'string', default: '4' },
    args: { type: 'string', default: SOFTWARE },
  },
});
const [width, height] = values.size.split('x').map(Number);
const frames = Number(values.frames);
if (positionals.length === 0 || !(width > 0 && height > 0) || !(Number(values.runs) > 0) || !(frames > 0)
    || !['0', '4'].includes(values.samples)) {
  console.error('usage: node measure.mjs [--runs N] [--size WxH] [--path FILE.csv [--frames N]] [--samples 0|4]'
    + ' [--args OPTIONS] FOLDER...');
  process.exit(2);
}
const places = values.path === undefined ? [] : along(values.path);

/** Returns places of a recorded path, the same time apart: x, y, z, yaw, pitch, roll. */
function along(file) {
  const rows = readFileSync(file, 'utf8').trim().split('\n').slice(1).map((line) => line.split(',').map(Number));
  const [first] = rows[0];
  const [last] = rows.at(-1);
  return Array.from({ length: frames }, (_, frame) => {
    const t = first + ((last - first) * (frame + 0.5)) / frames;
    const next = Math.max(1, rows.findIndex((row) => row[0] >= t));
    const [from, to] = [rows[next - 1], rows[next]];
    const share = (t - from[0]) / (to[0] - from[0]);
    return from.slice(1).map((value, i) => value + (to[i + 1] - value) * share);
  });
}

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

/** Runs in the page, before its own scripts: notes when it has its first picture, and lets it rest then. */
function firstPicture(smooth) {
  // A picture is drawn when its pixels can be read; X_ITE draws into a buffer of its own before.
  window.drawn = () => {
    const gl = document.querySelector('x3d-canvas').shadowRoot.querySelector('canvas').getContext('webgl2');
    const bound = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound);
  };
  if (!smooth) {
    window.customElements.whenDefined('x3d-canvas').then(() => {
      document.querySelector('x3d-canvas').browser.setBrowserOption('Antialiased', false);
    });
  }
  let shown;
  Object.defineProperty(window, 'selectiveRenderer', {
    get: () => shown,
    set: (value) => {
      shown = value;
      window.readyAt = performance.now();
      window.drawn();
      window.pictureAt = performance.now();
      value.walker.walks = false;
      value.world.browser.endUpdate();
    },
  });
}

/** Runs in the page: draws a frame at each place; returns how many a second. */
async function walk(along) {
  const { world } = window.selectiveRenderer;
  world.browser.beginUpdate();
  const began = performance.now();
  for (const [x, y, z, yaw, pitch, roll] of along) {
    world.setPose({ x, y, z, yaw, pitch, roll });
    await world.browser.nextFrame();
    window.drawn();
  }
  return (1000 * along.length) / (performance.now() - began);
}

/** Runs in the page: reads the versions that come later, and draws two frames, so that neither counts as a frame. */
async function prepare() {
  const { world } = window.selectiveRenderer;
  const scale = world.browser.getBrowserOption('ContentScale');
  world.browser.setBrowserOption('ContentScale', 0.1); // reading waits for frames
  world.browser.beginUpdate();
  while (await world.loadNext());
  world.browser.setBrowserOption('ContentScale', scale);
  await world.browser.nextFrame();
  await world.browser.nextFrame();
  window.drawn();
  world.browser.endUpdate();
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
    await page.evaluateOnNewDocument(firstPicture, values.samples !== '0');
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForFunction(() => window.pictureAt ?? document.querySelector('#status.failed'), { timeout: 500_000 });
    const fault = await page.$eval('#status', (status) => status.classList.contains('failed') && status.textContent);
    if (fault) {
      throw new Error(`${folder}: ${fault}`);
    }
    const first = await page.evaluate(() => {
      const files = performance.getEntriesByType('resource').map((entry) => entry.responseEnd);
      return { ready: (window.readyAt - Math.max(...files)) / 1000, picture: (window.pictureAt - window.readyAt) / 1000 };
    });
    const after = await processorTime(session);
    const run = { ...first, page: after.page - before.page, drawing: after.drawing - before.drawing };
    if (places.length === 0) {
      return run;
    }
    await page.evaluate(prepare);
    const standing = await processorTime(session);
    run.fps = await page.evaluate(walk, places);
    const walked = await processorTime(session);
    const each = (part) => (1000 * (walked[part] - standing[part])) / places.length;
    return { ...run, pageFrame: each('page'), drawingFrame: each('drawing') };
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

const COLUMNS = [
  ['ready after its bytes', 'ready', (value) => `${value.toFixed(1)} s`],
  ['and drawn', 'picture', (value) => `${value.toFixed(1)} s`],
  ['processor time: page', 'page', (value) => `${value.toFixed(1)} s`],
  ['drawing', 'drawing', (value) => `${value.toFixed(1)} s`],
];
if (places.length > 0) {
  COLUMNS.push(
    ['frames per second', 'fps', (value) => value.toFixed(value < 10 ? 2 : 0)],
    ['processor time of a frame: page', 'pageFrame', (value) => `${value.toFixed(0)} ms`],
    ['drawing', 'drawingFrame', (value) => `${value.toFixed(0)} ms`],
  );
}
console.log(`| page | ${COLUMNS.map(([name]) => name).join(' | ')} |`);
console.log(`| --- |${' --- |'.repeat(COLUMNS.length)}`);
for (const folder of positionals) {
  const runs = [];
  for (let run = 0; run < Number(values.runs); run++) {
    runs.push(await measure(path.resolve(folder)));
  }
  const cells = COLUMNS.map(([, key, text]) => text(median(runs, key)));
  console.log(`| ${path.basename(folder)} | ${cells.join(' | ')} |`);
}
