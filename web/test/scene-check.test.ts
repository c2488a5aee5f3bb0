// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { World } from '../src/scene/world.js';
import { Wording, type Slot, type Study, type Trial } from '../src/study/description.js';
import { sceneCheckPlugin, shows } from '../src/study/scene-check.js';
import type { Stage } from '../src/study/stage.js';

const TRIAL: Trial = { block: 'main', levels: {}, scene: 'hall', viewpoint: 'Door', condition: 'selective', choices: {}, stay: 'turn' };

function study(content: Partial<Study>, conditions: readonly Slot['condition'][] = ['selective']): Study {
  return {
    name: 'Hall',
    checksum: '',
    languages: ['en'],
    fade: 0,
    scenes: {},
    steps: {},
    texts: {},
    slots: conditions.map((condition, slot) => ({ slot, participant: '001', group: condition, condition, seed: 1, steps: [] })),
    ...content,
  };
}

/** A device on which a picture of each scene takes so many milliseconds. */
class Device {
  readonly drawn: unknown[] = [];
  private clock = 0;
  private scene = '';
  private view: Record<string, unknown> = {};

  constructor(readonly milliseconds: Record<string, number>) {
    vi.spyOn(performance, 'now').mockImplementation(() => this.clock);
  }

  private readonly world = {
    setCondition: (condition: string) => { this.view = { ...this.view, condition }; },
    hold: (choices: unknown) => { this.view = { ...this.view, choices }; },
    visitNamed: (viewpoint: string) => { this.view = { ...this.view, viewpoint }; },
    release: () => undefined,
    nextFrame: () => {
      this.clock += this.milliseconds[this.scene] ?? expect.unreachable(this.scene);
      return Promise.resolve();
    },
  } as unknown as World;

  readonly stage = {
    open: (scene: string) => {
      this.scene = scene;
      this.view = { scene };
      return Promise.resolve({ world: this.world });
    },
    show: () => { this.drawn.push(this.view); },
    hide: () => undefined,
  } as unknown as Stage;
}

interface Check {
  readonly display: HTMLElement;
  readonly rates: number[];
  readonly over: Promise<unknown>;
}

function check(checked: Study, device: Device, needed = 0): Check {
  const rates: number[] = [];
  const words = new Wording({ 'web.slow': '{0} of {1}', 'web.slow.again': 'Again' });
  const Plugin = sceneCheckPlugin(checked, device.stage, words, needed, (rate) => { rates.push(rate); });
  const display = document.createElement('div');
  document.body.replaceChildren(display);
  return { display, rates, over: new Plugin().trial(display, { type: Plugin }) as Promise<unknown> };
}

beforeEach(() => { document.body.replaceChildren(); });
afterEach(() => { vi.restoreAllMocks(); });

describe('the check of the device', () => {
  it('draws a scene in the condition that has most to draw, whatever its first trial shows', async () => {
    const device = new Device({ hall: 20 });
    const trials: Trial[] = [
      { ...TRIAL, block: 'training', condition: 'high-low', choices: { Lamp: 1 } },
      { ...TRIAL, condition: 'high', choices: { Lamp: 0 } },
      { ...TRIAL, condition: 'high', choices: { Lamp: -1 } },
    ];
    const { rates, over } = check(study({ trials }), device);
    expect(await over).toEqual({ frames_per_second: 50 });
    expect(rates).toEqual([50]);
    expect(device.drawn).toEqual([{ scene: 'hall', viewpoint: 'Door', condition: 'high', choices: { Lamp: 0 } }]);
  });

  it('draws each scene, of which the slowest counts; the first stays open', async () => {
    const device = new Device({ hall: 20, yard: 50, attic: 10 });
    const trials = ['hall', 'yard', 'hall', 'attic'].map((scene): Trial => ({ ...TRIAL, scene }));
    const { rates, over } = check(study({ trials }), device, 15);
    await over;
    expect(rates).toEqual([20]);
    expect(device.drawn.map((view) => (view as { scene: string }).scene)).toEqual(['attic', 'yard', 'hall']);
  });

  it('draws eight scenes at most', async () => {
    const names = Array.from({ length: 12 }, (_, i) => `scene${i}`);
    const device = new Device(Object.fromEntries(names.map((name) => [name, 20])));
    await check(study({ trials: names.map((scene): Trial => ({ ...TRIAL, scene })) }), device).over;
    expect(device.drawn).toHaveLength(8);
  });

  it('tells a device that is too slow for one of the scenes, and measures again', async () => {
    const device = new Device({ hall: 20, yard: 100 });
    const trials = ['hall', 'yard'].map((scene): Trial => ({ ...TRIAL, scene }));
    const { display, rates, over } = check(study({ trials }), device, 30);
    await expect.poll(() => display.querySelector('[role=alert]')?.textContent).toBe('10 of 30');
    expect(rates).toEqual([]);
    device.milliseconds.yard = 25;
    display.querySelector('button')?.click();
    await over;
    expect(rates).toEqual([40]);
  });

  it('draws the exposures as the costliest group sees them; a practice only where there is nothing else', async () => {
    const practice = { kind: 'practice', scene: 'yard', viewpoint: 'Gate' } as const;
    const exposure = { kind: 'exposure', scene: 'hall', area: 'hall', viewpoint: 'Door', seconds: 5, stay: 'free' } as const;
    const device = new Device({ hall: 20, yard: 20 });
    await check(study({ steps: { practice, hall: exposure } }, ['selective', 'high']), device).over;
    await check(study({ steps: { practice } }, ['random']), device).over;
    expect(device.drawn).toEqual([
      { scene: 'hall', viewpoint: 'Door', condition: 'high', choices: {} },
      { scene: 'yard', viewpoint: 'Gate', condition: 'random', choices: {} },
    ]);
  });

  it('is not there for a study without scenes', () => {
    expect(shows(study({ steps: { form: { kind: 'form' } } }))).toBe(false);
    expect(shows(study({ trials: [TRIAL] }))).toBe(true);
  });
});
