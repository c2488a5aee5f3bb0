/** The receiver that stands for JATOS, which serves the page then. */
export const JATOS = 'jatos';

/** Whether the scenes are shown in a headset of the browser: nobody is asked, people choose, or nobody takes part without. */
const HEADSET = ['no', 'offer', 'require'] as const;

/** A lab sets these in study-settings.json. */
export interface Settings {
  /** Address of the receiver of the data; JATOS for jatos.js; empty for none. */
  readonly receiver: string;
  /** Address that participants are sent to at the end; empty for none. */
  readonly completion: string;
  readonly fullScreen: boolean;
  /** Pixels that the window must have. */
  readonly minWidth: number;
  readonly minHeight: number;
  /** Pictures per second that the screen must show; 0 for any. */
  readonly minRefresh: number;
  /** Pictures of the scene that must come in a second before the session begins; 0 for any. */
  readonly minFrameRate: number;
  readonly headset: (typeof HEADSET)[number];
}

/** Checks what study-settings.json holds; a key that is missing has its usual value. */
export function settings(json: unknown): Settings {
  const found = (json ?? {}) as Partial<Record<keyof Settings, unknown>>;
  const address = (key: 'receiver' | 'completion'): string => {
    const value = found[key] ?? '';
    if (typeof value !== 'string' || (value !== '' && !(key === 'receiver' && value === JATOS) && !/^(https?:\/\/|\.{0,2}\/)/.test(value))) {
      throw new Error(`study-settings.json: "${key}" must be an address that begins with https://, or ""`);
    }
    return value;
  };
  const number = (key: 'minWidth' | 'minHeight' | 'minRefresh' | 'minFrameRate'): number => {
    const value = found[key] ?? 0;
    if (typeof value !== 'number' || !(value >= 0)) {
      throw new Error(`study-settings.json: "${key}" must be a number, 0 or above`);
    }
    return value;
  };
  return {
    receiver: address('receiver'),
    completion: address('completion'),
    fullScreen: found.fullScreen !== false,
    minWidth: number('minWidth'),
    minHeight: number('minHeight'),
    minRefresh: number('minRefresh'),
    minFrameRate: number('minFrameRate'),
    headset: worn(found.headset),
  };
}

function worn(value: unknown = 'no'): Settings['headset'] {
  const found = HEADSET.find((each) => each === value);
  if (!found) {
    throw new Error('study-settings.json: "headset" must be "offer", "require" or "no"');
  }
  return found;
}

/** The names under which Prolific and Sona tell who comes. */
const RECRUITMENT = ['PROLIFIC_PID', 'STUDY_ID', 'SESSION_ID', 'sona_id', 'survey_code', 'id'];

/** Returns what the page's address tells of the recruitment. */
export function recruitment(query: string): Record<string, string> {
  const asked = new URLSearchParams(query);
  return Object.fromEntries(
    RECRUITMENT.flatMap((name) => {
      const value = asked.get(name);
      return value ? [[name, value.slice(0, 200)]] : [];
    }),
  );
}

/**
 * Returns the index, from 0, of the place of the plan that the page's address names, which counts them from 1 as a
 * receiver does; undefined for none.
 */
export function askedSlot(query: string, slots: number): number | undefined {
  const asked = new URLSearchParams(query).get('slot') ?? '';
  const slot = /^\d{1,6}$/.test(asked) ? Number(asked) : NaN;
  return slot >= 1 && slot <= slots ? slot - 1 : undefined;
}

/** Returns the language to show: the one asked for, else the first of the browser's that the study has. */
export function language(query: string, browsers: readonly string[], studys: readonly string[]): string {
  const wanted = [new URLSearchParams(query).get('lang') ?? '', ...browsers];
  const base = (code: string): string => code.toLowerCase().split(/[-_]/)[0] ?? '';
  for (const each of wanted) {
    const found = studys.find((one) => one === each) ?? studys.find((one) => base(one) === base(each));
    if (found !== undefined) {
      return found;
    }
  }
  return studys[0] ?? 'en';
}

/** Returns the address at the end, with the ids of the recruitment in the place of {their names}. */
export function completion(address: string, ids: Readonly<Record<string, string>>): string {
  return address.replace(/\{(\w+)\}/g, (place, name: string) => {
    const id = ids[name];
    return id === undefined ? place : encodeURIComponent(id);
  });
}
