import { type JsPsychPlugin, ParameterType, type TrialType } from 'jspsych';
import type { Wording } from '../description.js';
import { element } from '../fields.js';
import type { Stage } from '../stage.js';

const info = {
  name: 'headset-entry',
  version: '1.0.0',
  parameters: {
    /** Name of the scene that comes next. */
    scene: { type: ParameterType.STRING, default: undefined },
    /** What to know of it on the screen, and in the headset. */
    on_screen: { type: ParameterType.STRING, array: true, default: [] },
    in_headset: { type: ParameterType.STRING, array: true, default: [] },
  },
  data: { headset: { type: ParameterType.BOOL } },
} as const;

type Parameters = TrialType<typeof info>;

/** The plugin of jsPsych that tells what comes next, in the headset if it is worn, and lets people put it on. */
export type EntryPlugin = new () => JsPsychPlugin<typeof info>;

/**
 * Makes the plugin.
 *
 * @param required whether the study is for headsets only
 */
export function entryPlugin(stage: Stage, words: Wording, required: boolean): EntryPlugin & { info: typeof info } {
  return class {
    static readonly info = info;

    async trial(display: HTMLElement, trial: Parameters, ready?: () => void): Promise<{ headset: boolean }> {
      ready?.();
      const status = element('p', 'loading');
      display.replaceChildren(status);
      await stage.open(trial.scene, (percent) => { status.textContent = words.loading(percent); });
      for (;;) {
        if (stage.worn) {
          if (await stage.tell(trial.in_headset ?? [], words.of('web.begin'))) {
            break;
          }
        } else if (await chosen(display, stage, words, trial, required)) {
          break;
        }
      }
      display.replaceChildren();
      return { headset: stage.worn };
    }
  };
}

/** Lets somebody choose between headset and screen; returns whether the screen was chosen, else the headset is worn. */
async function chosen(
  display: HTMLElement,
  stage: Stage,
  words: Wording,
  trial: Parameters,
  required: boolean,
): Promise<boolean> {
  const fault = element('p', 'fault');
  fault.setAttribute('role', 'alert');
  const lines = stage.onScreen ? trial.on_screen : [words.of('web.headset.put-on')];
  const text = (lines ?? []).map((line) => element('p', '', line));
  return new Promise((resolve) => {
    const screen = button(words.of(stage.onScreen ? 'web.begin' : 'web.headset.screen'), () => {
      resolve(stage.onScreen);
      stage.onScreen = true;
    });
    const headset = button(words.of('web.headset.enter'), () => {
      headset.disabled = true; // until the session is there, or is refused
      stage.enter().then(
        () => { resolve(false); },
        (error: unknown) => {
          headset.disabled = false;
          fault.textContent = `${words.of('web.headset.failed')} ${error instanceof Error ? error.message : String(error)}`;
        },
      );
    });
    const buttons = element('div', 'buttons');
    buttons.append(...(stage.onScreen ? [screen] : required ? [headset] : [headset, screen]));
    display.replaceChildren(...text, fault, buttons);
  });
}

function button(text: string, pressed: () => void): HTMLButtonElement {
  const made = document.createElement('button');
  made.type = 'button';
  made.className = 'jspsych-btn';
  made.textContent = text;
  made.addEventListener('click', pressed);
  return made;
}
