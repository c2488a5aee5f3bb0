// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import type { World } from '../src/scene/world.js';
import { Wording, type Page, type Study, type Trial } from '../src/study/description.js';
import { Recorder } from '../src/study/recorder.js';
import type { Stage } from '../src/study/stage.js';
import type { StepContext } from '../src/study/steps.js';
import { blockPlugin } from '../src/study/trials/block.js';

const TRIAL: Trial = { block: 'main', levels: { wall: 'red' }, scene: 'hall', viewpoint: '', condition: 'high', choices: {}, stay: 'turn' };
const CONSENT: Page = {
  id: 'consent',
  questions: [{
    id: 'agree',
    kind: 'yes-no',
    must: 'yes',
    fields: [{ type: 'choice', options: [{ value: 'yes', label: 'Yes' }, { value: 'no', label: 'No' }] }],
  }],
};

/** A scene without objects, whose frames come at once. */
const WORLD = {
  objects: [],
  entered: () => [],
  listen: () => () => undefined,
  setCondition: () => undefined,
  visit: () => undefined,
  headlight: () => undefined,
  hold: () => undefined,
  release: () => undefined,
  pose: () => ({ x: 0, y: 0, z: 0, yaw: 0, pitch: 0, roll: 0 }),
  nextFrame: () => Promise.resolve(),
} as unknown as World;

const STAGE = {
  open: () => Promise.resolve({ world: WORLD, walker: {} }),
  release: () => undefined,
  show: () => undefined,
  hide: () => undefined,
} as unknown as Stage;

/** Runs a block of two trials that ask for consent; returns its display and what came of it. */
function block(done: readonly string[] = []): { display: HTMLElement; records: Record<string, unknown>[]; events: string[]; over: Promise<unknown> } {
  const study = { trials: [TRIAL] } as unknown as Study;
  const records: Record<string, unknown>[] = [];
  const events: string[] = [];
  const identity = {
    study: 'Hall', checksum: '', session: 's', slot: 1, participant: '001', group: 'all', condition: 'high', language: 'en',
  };
  const context: StepContext = {
    study,
    slot: { slot: 0, participant: '001', group: 'all', condition: 'high', seed: 1, steps: ['main'], trials: { main: [[0, 0]] } },
    texts: { words: {}, questionnaires: { sure: [CONSENT] }, phases: { main: [{ show: 'questions', questionnaire: 'sure' }] } },
    words: new Wording({ 'web.block.left': '{0} left' }),
    stage: STAGE,
    recorder: new Recorder(identity, {
      send: (record) => { records.push(record as Record<string, unknown>); },
      finish: () => Promise.resolve(),
    }),
    headset: 'no',
    repeated: '',
    first: () => ({}),
    begun: (step) => { events.push(`${step} begun`); },
    done,
    wrong: [],
    ended: (step) => { events.push(`${step} ended`); },
    refused: () => { events.push('refused'); },
  };
  const Plugin = blockPlugin(context, { kind: 'block', rest: 0 });
  const display = document.createElement('div');
  document.body.replaceChildren(display);
  const over = new Plugin().trial(display, { type: Plugin, block: 'main' }) as Promise<unknown>;
  return { display, records, events, over };
}

async function press(display: HTMLElement, text: string): Promise<void> {
  await expect.poll(() => button(display, text)?.disabled).toBe(false);
  button(display, text)?.click();
}

function button(display: HTMLElement, text: string): HTMLButtonElement | undefined {
  return [...display.querySelectorAll('button')].find((each) => each.textContent === text);
}

async function answer(display: HTMLElement, value: 'yes' | 'no'): Promise<void> {
  await expect.poll(() => display.querySelectorAll('input[type=radio]').length).toBe(2);
  display.querySelectorAll<HTMLInputElement>('input[type=radio]')[value === 'yes' ? 0 : 1]?.click();
  await press(display, 'next');
}

describe('a block whose trials ask for consent', () => {
  it('goes on with who gives it', async () => {
    const { display, records, events, over } = block();
    await press(display, 'web.begin');
    await answer(display, 'yes');
    await expect.poll(() => records.length).toBe(1);
    await answer(display, 'yes');
    expect(await over).toEqual({ failed: false });
    expect(records.map(({ step, answers }) => [step, (answers as { value: string }[] | undefined)?.map((each) => each.value)])).toEqual([
      ['main-001', ['yes']], ['main-002', ['yes']], ['main', undefined],
    ]);
    expect(events).toEqual(['main-001 begun', 'main-001 ended', 'main-002 begun', 'main-002 ended', 'main ended']);
  });

  it('ends the session of who refuses it, with a record of the refusal alone', async () => {
    const { display, records, events, over } = block();
    await press(display, 'web.begin');
    await answer(display, 'no');
    await press(display, 'form.cancel');
    await expect.poll(() => events).toEqual(['main-001 begun', 'refused']);
    await over;
    expect(records).toHaveLength(1);
    expect(records[0]).toMatchObject({ step: 'main-001', block: 'main', trial: 1, round: 1, levels: { wall: 'red' }, refused: true });
    expect(records[0]).not.toHaveProperty('answers');
    expect(display.childElementCount).toBe(0);
  });
});

describe('a block that was left', () => {
  it('says how many of its trials are left', async () => {
    const { display } = block(['main-001']);
    await expect.poll(() => button(display, 'web.begin')?.disabled).toBe(false);
    expect(display.querySelector('p')?.textContent).toBe('1 left');
  });
});
