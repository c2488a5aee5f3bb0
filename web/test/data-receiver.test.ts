import { IDBFactory } from 'fake-indexeddb';
import 'fake-indexeddb/auto';
import { execFile, spawn, type ChildProcess } from 'node:child_process';
import { mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { createInterface } from 'node:readline';
import { connect } from 'node:net';
import { promisify } from 'node:util';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { HttpSink } from '../src/data/http-sink.js';
import { uuid } from '../src/data/session.js';
import type { Waiting } from '../src/data/sink.js';
import { Network, type Fate } from './network.js';

const RECEIVE = path.resolve(import.meta.dirname, '../../tools/web-receiver/receive.py');
const ORIGIN = 'https://lab.example.org';
const SESSION = '7c0e2a52-5d0b-4c12-9d3e-000000000001';
const PATIENT: Waiting = { begin: () => new Promise(() => undefined), trouble: () => undefined, end: () => undefined };

describe('the reference receiver', () => {
  let folder: string;
  let database: string;
  let receiver: ChildProcess | undefined;
  let url: string;
  let log: string;

  beforeEach(async () => {
    folder = await mkdtemp(path.join(tmpdir(), 'receiver-'));
    database = path.join(folder, 'data.sqlite');
    await start();
  });

  afterEach(async () => {
    await stop();
    await rm(folder, { recursive: true });
  });

  async function start(slots = 3, ...more: string[]): Promise<void> {
    const options = ['--study', 'Kitchen', '--origin', ORIGIN, '--slots', String(slots), '--port', '0', ...more];
    receiver = spawn('python3', [RECEIVE, database, ...options], { stdio: ['ignore', 'pipe', 'pipe'] });
    log = '';
    receiver.stderr?.on('data', (text: Buffer) => { log += text.toString(); });
    const lines = createInterface({ input: receiver.stdout ?? process.stdin });
    for await (const line of lines) {
      url = line.replace('receiving at ', '');
      break;
    }
  }

  async function stop(signal: NodeJS.Signals = 'SIGINT'): Promise<void> {
    const stopped = receiver;
    receiver = undefined;
    if (stopped !== undefined) {
      await new Promise((resolve) => {
        stopped.on('exit', resolve);
        stopped.kill(signal);
      });
    }
  }

  async function post(what: string, body: unknown, origin = ORIGIN): Promise<{ status: number; answer: unknown }> {
    const answer = await fetch(`${url}/${what}`, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', Origin: origin },
      body: typeof body === 'string' ? body : JSON.stringify(body),
    });
    return { status: answer.status, answer: await answer.json() };
  }

  async function command(...options: string[]): Promise<string> {
    return (await promisify(execFile)('python3', [RECEIVE, database, ...options])).stdout;
  }

  function part(number: number, records: unknown[], final = false): object {
    return { study: 'Kitchen', session: SESSION, part: number, final, records };
  }

  it('says in one sentence that its port is taken, and which one it uses by default', async () => {
    const port = new URL(url).port;
    const options = ['--study', 'Kitchen', '--origin', ORIGIN, '--port', port];
    const second = promisify(execFile)('python3', [RECEIVE, path.join(folder, 'second.sqlite'), ...options]);
    const refused: unknown = await second.catch((error: unknown) => error);
    const said = (refused as { stderr: string }).stderr;
    expect(said).toContain(`--port ${port}: another program listens at 127.0.0.1:${port} already; name another port`);
    expect(said).not.toContain('Traceback');
    expect((await promisify(execFile)('python3', [RECEIVE, '--help'])).stdout).toMatch(/--port.*default: 8010/s);
  });

  it('has what it answered on the disk, each part once, gaps and all', async () => {
    const odd = { text: 'ά"\u2028\ud800', number: 0.1, large: 2 ** 70, nested: [null, true, {}] };
    expect(await post('data', part(0, [odd, 2]))).toEqual({ status: 200, answer: { received: 2 } });
    expect(await post('data', part(0, [odd, 2]))).toEqual({ status: 200, answer: { received: 2 } });
    expect(await post('some/where/data', part(3, [], true))).toEqual({ status: 200, answer: { received: 0 } });
    expect(await post('data', part(2, ['late']))).toEqual({ status: 200, answer: { received: 1 } });
    expect(await post('data', part(0, ['other']))).toMatchObject({ status: 409 });
    expect((await post('slot', { study: 'Kitchen', session: SESSION })).answer).toEqual({ slot: 1 });
    await stop('SIGKILL');
    const results = path.join(folder, 'results');
    await command('--write', results);
    expect((await readdir(results)).sort()).toEqual([`${SESSION}.jsonl`, 'sessions.csv']);
    const lines = (await readFile(path.join(results, `${SESSION}.jsonl`), 'utf8')).split('\n');
    expect(lines.map((line) => (line === '' ? '' : (JSON.parse(line) as unknown)))).toEqual([odd, 2, 'late', '']);
    expect(await readFile(path.join(results, 'sessions.csv'), 'utf8')).toBe(
      `session,slot,parts,missing,final\n${SESSION},1,3,1,yes\n`,
    );
    await start();
    expect(await post('data', part(0, ['other']))).toMatchObject({ status: 409 });
    // Written again, the folder has what has come since.
    expect(await post('data', part(1, ['missed']))).toMatchObject({ status: 200 });
    await command('--write', results);
    expect(await readFile(path.join(results, 'sessions.csv'), 'utf8')).toBe(
      `session,slot,parts,missing,final\n${SESSION},1,4,,yes\n`,
    );
    expect(await readFile(path.join(results, `${SESSION}.jsonl`), 'utf8')).toContain('"missed"\n"late"');
    expect((await readdir(results)).sort()).toEqual([`${SESSION}.jsonl`, 'sessions.csv']);
    // What it would not write itself is somebody's.
    await writeFile(path.join(results, 'notes.txt'), 'mine');
    await expect(command('--write', results)).rejects.toThrow('has notes.txt, which no --write of this database made');
  });

  it('refuses what is not a part of its study, and stores nothing of it', async () => {
    const refused: [string, number, unknown][] = [
      ['another study', 404, { study: 'Lounge', session: SESSION, part: 0, final: false, records: [] }],
      ['no JSON', 400, '{"study": "Kitchen"'],
      ['NaN', 400, JSON.stringify(part(0, [1])).replace('[1]', '[NaN]')],
      ['deep nesting', 400, JSON.stringify(part(0, [1])).replace('[1]', '['.repeat(200_000) + ']'.repeat(200_000))],
      ['a list', 404, []],
      ['a path for a session', 400, { ...part(0, []), session: '../../etc/passwd' }],
      ['a session in capitals', 400, { ...part(0, []), session: SESSION.toUpperCase() }],
      ['a negative part', 400, part(-1, [])],
      ['a part that is true', 400, { ...part(0, []), part: true }],
      ['a huge part', 400, part(1e9, [])],
      ['records that are none', 400, { ...part(0, []), records: 'all' }],
      ['no final', 400, { ...part(0, []), final: undefined }],
    ];
    for (const [what, status, body] of refused) {
      expect([what, (await post('data', body)).status]).toEqual([what, status]);
    }
    // A connection may be closed while the client still sends what is too much.
    const answered = await post('data', JSON.stringify(part(0, ['x'.repeat(16 << 20)]))).catch(() => ({ status: 413 }));
    expect(answered.status).toBe(413);
    await command('--write', path.join(folder, 'results'));
    expect(await readdir(path.join(folder, 'results'))).toEqual(['sessions.csv']);
  });

  it('answers pages of the named origins only', async () => {
    const asked = { method: 'OPTIONS', headers: { Origin: ORIGIN, 'Access-Control-Request-Method': 'POST' } };
    const allowed = await fetch(`${url}/data`, asked);
    expect([allowed.status, allowed.headers.get('access-control-allow-origin')]).toEqual([204, ORIGIN]);
    expect(allowed.headers.get('access-control-allow-headers')).toBe('Content-Type');
    const other = await fetch(`${url}/data`, { ...asked, headers: { Origin: 'https://other.example' } });
    expect([other.status, other.headers.get('access-control-allow-origin')]).toEqual([403, null]);
    expect(await post('data', part(0, [1]), 'https://other.example')).toMatchObject({ status: 403 });
  });

  it('refuses what is set up wrongly with a sentence that says what to do, and so does a sink without a receiver', async () => {
    const place = async (study: string): Promise<string> => {
      // A browser names the page's origin itself; a proxy does so here.
      const network = await Network.open(async (what, body) => {
        const { status, answer } = await post(what.slice(1), body, origin);
        return { status, body: JSON.stringify(answer) };
      });
      const sink = await HttpSink.open({ url: network.url, study, participant: '', waiting: PATIENT });
      try {
        return await sink.slot().then((slot) => `place ${String(slot)}`, (error: unknown) => String(error).replace(network.url, 'URL'));
      } finally {
        sink.close();
        await network.close();
      }
    };
    let origin = ORIGIN;
    expect(await place('Kitchen')).toBe('place 1');
    expect(await place('Lounge')).toBe('Error: URL does not receive the study "Lounge". Researchers: start the receiver with '
      + '--study "Lounge", or correct "receiver" in study-settings.json.');
    origin = 'https://elsewhere.example.org';
    expect(await place('Kitchen')).toBe('Error: URL does not allow this page. Researchers: start the receiver with the page\'s --origin.');
    await stop();
    const sink = await HttpSink.open({ url, study: 'Kitchen', participant: '', waiting: PATIENT });
    await expect(sink.slot()).rejects.toThrow(
      `${url}/slot does not answer. Researchers: does the receiver run there, and does it allow this page (--origin this page)?`,
    );
    sink.close();
  });

  it('keeps nothing of a request that was cut off', async () => {
    const socket = connect(Number(new URL(url).port), '127.0.0.1');
    const body = JSON.stringify(part(0, ['whole']));
    const head = `POST /data HTTP/1.1\r\nHost: x\r\nOrigin: ${ORIGIN}\r\nContent-Length: ${body.length + 5}\r\n\r\n`;
    await new Promise<void>((resolve) => {
      socket.resume().on('close', resolve);
      socket.end(head + body);
    });
    expect(await post('data', part(0, ['next']))).toMatchObject({ status: 200 });
  });

  it('writes no address of a participant down, also not of one whose request is no HTTP', async () => {
    const { hostname, port } = new URL(url);
    const socket = connect(Number(port), hostname);
    socket.end('BREW /pot COFFEE/1\r\n\r\n');
    await new Promise((resolve) => { socket.on('close', resolve).resume(); });
    await expect.poll(() => log).toContain('code 400');
    expect(log).not.toContain(hostname);
  });

  it('gives each session the next free place, the same again, and those of abandoned ones anew', async () => {
    const sessions = Array.from({ length: 4 }, uuid);
    const ask = (session: string | undefined) => post('slot', { study: 'Kitchen', session });
    const taken: unknown[] = [];
    for (const session of sessions.slice(0, 3)) {
      taken.push((await ask(session)).answer);
    }
    expect(taken).toEqual([{ slot: 1 }, { slot: 2 }, { slot: 3 }]);
    expect((await ask(sessions[1])).answer).toEqual({ slot: 2 });
    expect(await ask(sessions[3])).toMatchObject({ status: 410 });

    const message = { study: 'Kitchen', records: [], part: 0 };
    await post('data', { ...message, session: sessions[0], final: true });
    await post('data', { ...message, session: sessions[2], final: false });
    expect(await command('--give-back', '1')).toBe('');
    expect(await command('--give-back', '-1')).toBe(
      `2 is free again; it was that of ${sessions[1] ?? ''}\n3 is free again; it was that of ${sessions[2] ?? ''}\n`,
    );
    expect((await ask(sessions[3])).answer).toEqual({ slot: 2 });
    expect((await ask(sessions[0])).answer).toEqual({ slot: 1 });
  });

  it('says that it is full before the disk is', async () => {
    await stop();
    await start(0, '--megabytes', '1');
    expect(await post('data', part(0, ['x'.repeat(2 << 20)]))).toMatchObject({ status: 507 });
    expect(await post('data', part(1, ['x']))).toMatchObject({ status: 200 });
  });

  it('takes 500 participants at once over a bad network: none lost, none double, each place once', async () => {
    const participants = 500;
    const steps = 5;
    await stop();
    await start(participants);
    const arrived = new Map<string, () => void>();
    const network = await Network.open(async (what, body) => {
      const answer = await post(what.slice(1), body);
      const { records } = JSON.parse(body) as { records?: { participant: number; step: number }[] };
      records?.forEach((record) => arrived.get(`${record.participant} ${record.step}`)?.());
      return { status: answer.status, body: JSON.stringify(answer.answer) };
    });
    const bad: Fate[] = ['lost', 'answer lost', 'twice', 'fails', 'answered by a portal'];
    let requests = 0;
    network.fate = () => bad[requests++ % 15] ?? 'arrives';
    const sinks = await Promise.all(
      Array.from({ length: participants }, (_, i) =>
        HttpSink.open({
          url: network.url,
          study: 'Kitchen',
          participant: String(i),
          waiting: PATIENT,
          indexedDB: new IDBFactory(),
          pauses: { first: 5, longest: 500 },
        }),
      ),
    );
    const places = await Promise.all(
      sinks.map(async (sink, i) => {
        let place: number | undefined;
        for (let asked = 0; asked < 100 && place === undefined; asked++) {
          place = await sink.slot().catch(() => undefined);
        }
        for (let step = 0; step < steps; step++) {
          const there = new Promise<void>((resolve) => arrived.set(`${i} ${step}`, resolve));
          sink.send({ participant: i, step, log: 'x'.repeat(1000) });
          if (step % 2 === 0) {
            await there; // its answer may still be lost, and the next one comes meanwhile
          }
        }
        await sink.finish();
        return place;
      }),
    );
    await network.close();
    expect(network.requests).toBeGreaterThan(4 * participants);
    expect(places.sort((a, b) => (a ?? 0) - (b ?? 0))).toEqual(Array.from({ length: participants }, (_, i) => i + 1));

    const results = path.join(folder, 'results');
    await command('--write', results);
    const table = (await readFile(path.join(results, 'sessions.csv'), 'utf8')).trimEnd().split('\n').slice(1);
    expect(table).toHaveLength(participants);
    expect(table.filter((row) => !row.endsWith(',,yes'))).toEqual([]);
    for (const [i, sink] of sinks.entries()) {
      const lines = (await readFile(path.join(results, `${sink.session}.jsonl`), 'utf8')).trimEnd().split('\n');
      expect(lines.map((line) => (JSON.parse(line) as { participant: number; step: number }))).toEqual(
        Array.from({ length: steps }, (_, step) => ({ participant: i, step, log: 'x'.repeat(1000) })),
      );
    }
  });
});
