// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { Fade } from '../src/study/fade.js';
import { COLUMNS, HeadLog, type Log } from '../src/study/head-log.js';
import { Wording } from '../src/study/description.js';
import type { Stage } from '../src/study/stage.js';
import { exposurePlugin } from '../src/study/x3d-exposure.js';

describe('a fade', () => {
  it('comes and goes in addition to the exposure', () => {
    const fade = new Fade(2, 10);
    expect([-1, 0, 1, 2, 7, 12, 13, 14].map((t) => fade.brightness(t))).toEqual([0, 0, 0.5, 1, 1, 1, 0.5, 0]);
    expect([13.99, 14].map((t) => fade.over(t))).toEqual([false, true]);
  });

  it('of no time is the exposure alone', () => {
    const none = new Fade(0, 3);
    expect([0, 2.9, 3].map((t) => none.brightness(t))).toEqual([1, 1, 0]);
    expect(none.over(3)).toBe(true);
  });
});

describe('a head log', () => {
  it('has a row for each frame, in the order of its columns', () => {
    const log = new HeadLog(1000);
    log.frame(1016.6667, { x: 1, y: 1.6, z: -2.12345678, yaw: 90, pitch: -5, roll: 0 }, false);
    log.frame(1050, { x: 1, y: 1.6, z: -2, yaw: 90, pitch: -5, roll: 0 }, true);
    const { columns, rows } = log.log();
    expect(columns).toEqual(COLUMNS);
    expect(rows).toEqual([
      [0.016667, 1, 1.6, -2.123457, 90, -5, 0, 16.667, 0, 1.016667],
      [0.05, 1, 1.6, -2, 90, -5, 0, 33.333, 1, 1.05],
    ]);
  });

  it('has entries, exits and changes of objects as the desktop names them', () => {
    const log = new HeadLog(0);
    log.event(500, { kind: 'enter', area: 'DeskProx' });
    log.event(1500, { kind: 'switch', object: 'Switch_Lamp', choice: 0 });
    log.event(2000, { kind: 'exit', area: 'DeskProx' });
    expect(log.log().events).toEqual([
      { t: 0.5, event: 'enter', node: 'DeskProx' },
      { t: 1.5, event: 'switch', node: 'Switch_Lamp', choice: 0 },
      { t: 2, event: 'exit', node: 'DeskProx' },
    ]);
  });
});

describe('an exposure', () => {
  it('has a row of its end, when the last of its pictures has been seen', async () => {
    const world = {
      objects: [],
      entered: () => [],
      listen: () => () => undefined,
      setCondition: () => undefined,
      pose: () => ({ x: 1, y: 1.6, z: 2, yaw: 0, pitch: 0, roll: 0 }),
      nextFrame: () => new Promise((frame) => { setTimeout(frame, 1); }),
    };
    const stage = {
      open: () => Promise.resolve({ world, walker: { move: () => undefined } }),
      darken: () => undefined,
      release: () => undefined,
      show: () => undefined,
      hide: () => undefined,
    } as unknown as Stage;
    let logged: Log | undefined;
    const Plugin = exposurePlugin(stage, new Wording({}), (log) => { logged = log; });
    await new Plugin().trial(document.createElement('div'), {
      type: Plugin, scene: 'hall', viewpoint: '', seconds: 0.02, fade: 0, stay: 'turn', condition: 'high', seed: 1,
    });
    const rows = logged?.rows ?? [];
    const visible = COLUMNS.indexOf('visible');
    expect(rows.at(-1)?.[0]).toBeGreaterThanOrEqual(0.02);
    expect(rows.map((row) => row[visible])).toEqual([...rows.slice(1).map(() => 1), 0]);
  });
});
