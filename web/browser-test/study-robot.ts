import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from 'puppeteer-core';
import { ROOT } from './chromium.js';

/** Writes a study of one exposure: consent, two seconds in the office, what was there, one question; returns its file. */
export function officeStudy(folder: string): string {
  const scene = path.relative(folder, path.join(ROOT, 'scenes', 'trashcan.x3d')).split(path.sep).join('/');
  writeFileSync(
    path.join(folder, 'closing.json'),
    JSON.stringify({
      name: 'closing',
      pages: [{ title: 'Thank you', questions: [{ id: 'noticed', kind: 'text', text: 'What did you notice?' }] }],
    }),
  );
  writeFileSync(
    path.join(folder, 'things.csv'),
    'area,object,consistency,present,en\noffice,can,consistent,yes,Trash can\noffice,boat,inconsistent,no,Boat\n',
  );
  writeFileSync(
    path.join(folder, 'study.json'),
    JSON.stringify({
      name: 'Office',
      scene,
      conditions: ['selective', 'high'],
      participants: 6,
      areas: [{ name: 'office', viewpoint: 'OfficeView', seconds: 2 }],
      fade: 0.1,
      questionnaires: [{ kind: 'recognition', name: 'memory', items: 'things.csv' }, { file: 'closing.json' }],
    }),
  );
  return path.join(folder, 'study.json');
}

/** Returns the metadata of a version. */
function version(consistency: 'consistent' | 'inconsistent'): string {
  return `<MetadataSet containerField='value' name='${consistency}'>
    <MetadataString containerField='value' name='consistencyType' value='"${consistency}"'/>
    <MetadataString containerField='value' name='degreeOfConsistency' value='"high"'/>
    <MetadataString containerField='value' name='schemaBelonginess' value='"${consistency}Schema"'/></MetadataSet>`;
}

/**
 * Writes a study of two blocks, a practice and one of four trials in two conditions, with a factor between participants;
 * returns its file. The practice is in the condition high, which shows the cone on the left where no trial hides it.
 */
export function blocksStudy(folder: string): string {
  writeFileSync(path.join(folder, 'shelf.x3d'), `<X3D profile='Immersive' version='3.3'><Scene>
    <Viewpoint DEF='Front' position='0 0 6'/>
    <Transform translation='-1 0 0'><Switch DEF='Left' whichChoice='-1'>
      <MetadataSet containerField='metadata' name='Left'>${version('inconsistent')}${version('consistent')}</MetadataSet>
      <Shape><Cone/></Shape><Shape><Box/></Shape></Switch></Transform>
    <Transform translation='1 0 0'><Switch DEF='Right' whichChoice='-1'><Shape><Box/></Shape></Switch></Transform>
    <Switch DEF='Wall' whichChoice='0'><Transform translation='0 0 -3'><Shape><Appearance>
      <Material emissiveColor='0 0.5 0'/></Appearance><Box size='20 20 1'/></Shape></Transform></Switch></Scene></X3D>`);
  writeFileSync(path.join(folder, 'sides.csv'), 'side,choices,answer\nleft,Left=0,f\nright,Right=0,j\n');
  writeFileSync(path.join(folder, 'sure.json'), JSON.stringify({
    name: 'sure',
    pages: [{ questions: [{ id: 'sure', kind: 'scale', from: 1, to: 5, text: 'How sure are you?' }] }],
  }));
  const keys = { keys: ['f', 'j'], correct: '{answer}' };
  writeFileSync(path.join(folder, 'study.json'), JSON.stringify({
    name: 'Sides',
    scene: 'shelf.x3d',
    participants: 6,
    seed: 5,
    stay: 'turn',
    factors: [
      { name: 'task', varies: 'between', levels: [{ name: 'fast' }, { name: 'careful' }] },
      { name: 'wall', varies: 'within', levels: [{ name: 'green', choices: { Wall: 0 } }, { name: 'none', choices: { Wall: -1 } }] },
    ],
    blocks: [
      {
        name: 'training',
        factors: [],
        condition: 'high',
        stimuli: 'sides.csv',
        viewpoint: 'Front',
        practice: { correct: 1, rounds: 3 },
        trial: [
          { show: 'instruction', text: 'On which side is it? F: left, J: right.' },
          { show: 'exposure', seconds: 0.4, ...keys },
          { show: 'blank', ...keys },
          { show: 'feedback', seconds: 0.3, correct: 'Right: {side}', wrong: 'Wrong: {side}' },
        ],
      },
      {
        name: 'main',
        stimuli: 'sides.csv',
        order: 'random',
        rest: 2,
        viewpoint: 'Front',
        trial: [
          { show: 'fixation', seconds: 0.2 },
          { show: 'exposure', seconds: 0.4, choices: { Left: 1 }, ...keys },
          { show: 'blank', ...keys },
          { show: 'questions', questionnaire: 'sure' },
        ],
      },
    ],
    questionnaires: [{ file: 'sure.json', when: 'in-trials', name: 'sure' }],
  }));
  return path.join(folder, 'study.json');
}

/** Presses the button with a text, as soon as it is there and may be pressed. */
export async function press(page: Page, text: string): Promise<void> {
  await page.locator(`::-p-xpath(//button[normalize-space()='${text}' and not(@disabled)])`).setTimeout(120_000).click();
}

/** Waits until the page says a text. */
export async function told(page: Page, text: string): Promise<void> {
  await page.waitForFunction((wanted) => document.body.innerText.includes(wanted), { timeout: 120_000 }, text);
}

/** Answers the consent and the questions of the form, with the options of an index. */
export async function fillForm(page: Page, option: number): Promise<void> {
  await press(page, 'Begin');
  await page.waitForSelector('form.questionnaire', { timeout: 120_000 });
  await page.evaluate((index) => {
    document.querySelectorAll<HTMLElement>('.choice').forEach((box) => { [...box.querySelectorAll('input')].at(index)?.click(); });
    document.querySelectorAll<HTMLInputElement>('form input:not([type=radio], [type=checkbox])').forEach((line) => {
      line.value = '30';
      line.dispatchEvent(new Event('input', { bubbles: true }));
    });
  }, option);
  await press(page, 'Continue');
}

/** Says yes to all that may have been there, with the least confidence; writes the answer of the last page, and goes on. */
export async function writeAnswer(page: Page, text: string): Promise<void> {
  await page.waitForSelector('form.questionnaire .choice', { timeout: 120_000 });
  await page.evaluate(() => {
    document.querySelectorAll<HTMLElement>('.choice').forEach((box) => box.querySelector('input')?.click());
  });
  await press(page, 'Continue');
  const line = await page.waitForSelector('form.questionnaire :is(textarea, input)', { timeout: 120_000 });
  await line?.type(text);
  await press(page, 'Continue');
}

/** A record as the page sends it. */
export interface Received {
  readonly study?: string;
  readonly session: string;
  readonly slot: number;
  readonly step: string;
  readonly condition: string;
  readonly refused?: boolean;
  readonly repeated?: boolean;
  readonly response?: string;
  readonly correct?: boolean;
  readonly phases?: readonly { readonly phase: string; readonly seconds: number }[];
  readonly recruitment?: Readonly<Record<string, string>>;
  readonly device?: Readonly<Record<string, unknown>>;
  readonly answers?: readonly { readonly question: string; readonly value: string }[];
  readonly log?: { readonly columns: readonly string[]; readonly rows: readonly (readonly number[])[] };
}

const RECEIVE = path.join(ROOT, 'tools', 'web-receiver', 'receive.py');

/** The reference receiver, for pages of an origin. */
export class ReferenceReceiver {
  private constructor(
    readonly url: string,
    private readonly folder: string,
    private readonly origin: string,
    private readonly study: string,
    private child: ChildProcess,
  ) {}

  static async start(folder: string, origin: string, study = 'Office'): Promise<ReferenceReceiver> {
    const { child, url } = await ReferenceReceiver.listen(folder, origin, '0', study);
    return new ReferenceReceiver(url, folder, origin, study, child);
  }

  private static async listen(
    folder: string,
    origin: string,
    port: string,
    study: string,
  ): Promise<{ child: ChildProcess; url: string }> {
    const options = ['--study', study, '--origin', origin, '--slots', '6', '--port', port];
    const child = spawn('python3', [RECEIVE, database(folder), ...options], { stdio: ['ignore', 'pipe', 'inherit'] });
    const [first] = (await once(child.stdout, 'data')) as [Buffer];
    const url = /http:\/\/\S+?:\d+/.exec(first.toString())?.[0];
    if (!url) {
      throw new Error(`the receiver does not say where it listens: ${first.toString()}`);
    }
    return { child, url };
  }

  /** Returns the records of each session that have arrived, in the order of their parts, and the folder with their files. */
  written(): { records: Received[][]; data: string } {
    const data = path.join(mkdtempSync(path.join(this.folder, 'received-')), 'data');
    execFileSync('python3', [RECEIVE, database(this.folder), '--write', data]);
    const records = readdirSync(data).filter((name) => name.endsWith('.jsonl'))
      .map((name) => readFileSync(path.join(data, name), 'utf8').trim().split('\n').filter(Boolean)
        .map((line) => JSON.parse(line) as Received));
    return { records, data };
  }

  /** Returns how many places of the plan are taken. */
  taken(): number {
    const { data } = this.written();
    return readFileSync(path.join(data, 'sessions.csv'), 'utf8').trim().split('\n').slice(1)
      .filter((row) => row.split(',')[1] !== '').length;
  }

  /** Ends the receiver: from now on nothing arrives. */
  async stop(): Promise<void> {
    const ended = once(this.child, 'exit');
    this.child.kill();
    await ended;
  }

  /** Starts the receiver again at the address that pages know. */
  async restart(): Promise<void> {
    this.child = (await ReferenceReceiver.listen(this.folder, this.origin, new URL(this.url).port, this.study)).child;
  }
}

function database(folder: string): string {
  return path.join(folder, 'office.sqlite');
}

/** Sets keys of the settings that the lab has. */
export function set(site: string, keys: Readonly<Record<string, unknown>>): void {
  const file = path.join(site, 'study-settings.json');
  writeFileSync(file, JSON.stringify({ ...(JSON.parse(readFileSync(file, 'utf8')) as object), ...keys }));
}
