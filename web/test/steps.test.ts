// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { Wording, type Step, type Study } from '../src/study/description.js';
import { Recorder } from '../src/study/recorder.js';
import type { Stage } from '../src/study/stage.js';
import { timeline, type StepContext } from '../src/study/steps.js';

const WORDS = { 'web.exposure.place': 'Place {0} of {1}', 'web.exposure': 'You see it for {0} s.', 'web.turn': 'Turn.', 'web.walk': 'Walk.' };

/** Nothing is shown here. */
const STAGE = {} as unknown as Stage;

function exposure(area: string): Step {
  return { kind: 'exposure', scene: 'house', area, viewpoint: '', seconds: 5, stay: 'turn' };
}

/** Returns what the steps of a participant need. */
function context(order: readonly string[], more: Partial<StepContext> = {}): StepContext {
  const steps: Record<string, Step> = {
    form: { kind: 'form' },
    practice: { kind: 'practice', scene: 'house', viewpoint: '' },
    hall: exposure('hall'),
    yard: exposure('yard'),
    attic: exposure('attic'),
  };
  const identity = {
    study: '', checksum: '', session: '', slot: 1, participant: '001', group: 'all', condition: 'high', language: 'en',
  };
  return {
    study: { steps, fade: 0 } as unknown as Study,
    slot: { slot: 0, participant: '001', group: 'all', condition: 'high', seed: 1, steps: order },
    texts: { words: WORDS, questionnaires: {} },
    words: new Wording(WORDS),
    stage: STAGE,
    recorder: new Recorder(identity, { send: () => undefined, finish: () => Promise.resolve() }),
    headset: 'no',
    repeated: '',
    first: () => ({}),
    begun: () => undefined,
    done: [],
    wrong: [],
    ended: () => undefined,
    refused: () => undefined,
    ...more,
  };
}

/** Returns what is told before each exposure of a participant. */
function told(order: readonly string[], more: Partial<StepContext> = {}): string[] {
  return (timeline(context(order, more)) as { timeline: { stimulus?: string; on_screen?: readonly string[] }[] }[])
    .flatMap((step) => step.timeline)
    .flatMap(({ stimulus, on_screen }) => stimulus ?? (on_screen?.length ? [on_screen.join(' ')] : []))
    .map((text) => text.replaceAll(/<\/?p>/g, ' ').trim());
}

describe('what is told before an exposure', () => {
  it('says which of several it is, in the order of the participant', () => {
    expect(told(['form', 'practice', 'yard', 'hall', 'attic'])).toEqual([
      expect.stringContaining('Place 1 of 3'), expect.stringContaining('Place 2 of 3'), expect.stringContaining('Place 3 of 3'),
    ]);
  });

  it('counts those that are done, after the page was opened again', () => {
    expect(told(['form', 'hall', 'yard', 'attic'], { done: ['form', 'hall'] })).toEqual([
      expect.stringContaining('Place 2 of 3'), expect.stringContaining('Place 3 of 3'),
    ]);
  });

  it('says no place of a single one', () => {
    expect(told(['form', 'hall'])).toEqual([expect.not.stringContaining('Place')]);
  });

  it('says it in front of a headset, too', () => {
    expect(told(['hall', 'yard'], { headset: 'offer' })).toEqual([
      expect.stringContaining('Place 1 of 2'), expect.stringContaining('Place 2 of 2'),
    ]);
  });
});

describe('what is told in the practice', () => {
  const words = { 'web.walk': 'Walk.', 'web.practice.turn': 'Later you only look.', 'web.headset.walk': 'By head.', 'web.headset.practice': 'Squeeze.' };

  /** Returns what the practice shows in the picture and, with a headset, before it. */
  function practice(stays: readonly ('turn' | 'free')[], headset: StepContext['headset'] = 'no'): unknown[] {
    const steps: Record<string, Step> = { practice: { kind: 'practice', scene: 'house', viewpoint: '' } };
    stays.forEach((stay, i) => { steps[`exposure-${i}`] = { ...exposure('hall'), stay } as Step; });
    const made = timeline(context(['practice'], { study: { steps, fade: 0 } as unknown as Study, words: new Wording(words), headset }));
    return (made as { timeline: { hints?: unknown; in_headset?: unknown }[] }[])
      .flatMap((step) => step.timeline)
      .flatMap(({ hints, in_headset }) => [in_headset, hints])
      .filter((texts) => texts !== undefined);
  }

  it('says that one cannot walk later, if each exposure only turns', () => {
    expect(practice(['turn', 'turn'])).toEqual([['Walk.', 'Later you only look.']]);
    expect(practice(['turn'], 'offer')).toEqual([
      ['By head.', 'Later you only look.', 'Squeeze.'], ['Walk.', 'Later you only look.'],
    ]);
  });

  it('does not say so if one exposure walks, or there is none', () => {
    expect(practice(['turn', 'free'])).toEqual([['Walk.']]);
    expect(practice([])).toEqual([['Walk.']]);
  });
});
