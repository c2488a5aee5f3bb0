import { spawnSync } from 'node:child_process';
import { createReadStream, existsSync, mkdtempSync, rmSync, statSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import puppeteer, { type Browser } from 'puppeteer-core';

/** The root of the project. */
export const ROOT = path.resolve(import.meta.dirname, '..', '..');

/** Runs the program; returns what it prints. SELECTIVE_RENDERER names another command than the project's own. */
export function selectiveRenderer(...args: string[]): string {
  const [command = '', ...first] = (process.env.SELECTIVE_RENDERER ?? './selective-renderer').split(' ');
  const ended = spawnSync(command, [...first, ...args], { cwd: ROOT, encoding: 'utf8', maxBuffer: 1e8 });
  if (ended.status !== 0) {
    throw new Error(`selective-renderer ${args.join(' ')} ended with ${ended.status ?? 'a signal'}: ${ended.stderr}`);
  }
  return ended.stdout;
}

/** A folder for what a test writes. */
export function temporary(): { folder: string; remove: () => void } {
  const folder = mkdtempSync(path.join(tmpdir(), 'selective-renderer-'));
  return { folder, remove: () => { rmSync(folder, { recursive: true, force: true }); } };
}

const TYPES: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
};

/** Serves a folder as a web server without any settings does. */
export async function serve(folder: string): Promise<{ url: string; close: () => void }> {
  const server: Server = createServer((asked, answer) => {
    const name = decodeURIComponent(new URL(asked.url ?? '/', 'http://host').pathname);
    const file = path.join(folder, name.endsWith('/') ? `${name}index.html` : name);
    if (!file.startsWith(folder) || !existsSync(file) || !statSync(file).isFile()) {
      answer.writeHead(404).end();
      return;
    }
    answer.writeHead(200, { 'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(answer);
  });
  await new Promise<void>((listening) => { server.listen(0, '127.0.0.1', listening); });
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}/`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

/** Starts Chromium, which draws by software. CHROMIUM names another one than Debian's. */
export function launch(): Promise<Browser> {
  return puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    protocolTimeout: 900_000,
    args: [
      '--no-sandbox',
      '--use-gl=angle',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist',
      '--disable-background-networking',
      '--disable-component-update',
      '--no-first-run',
    ],
  });
}
