import type { LaterVersion } from '../scene/later.js';
import { CONDITIONS, type Condition, type ExportedScene } from '../scene/world.js';

/** scene.json beside the page says this; the command export writes it. */
export interface Description extends ExportedScene {
  readonly title: string;
  readonly condition: Condition;
  readonly seed: number;
  /** Bytes of the scene's files by their address, for the progress of loading. */
  readonly files: Readonly<Record<string, number>>;
}

/** Returns the bytes of the files that the first picture may need, by their address. */
export function firstFiles({ file, files, later = [] }: Description): Record<string, number> {
  const page = 'http://host/'; // addresses are compared, wherever the page is
  const base = new URL(file, page);
  const left = new Set(later.flatMap((version) => version.files).map((name) => new URL(name, base).href));
  return Object.fromEntries(Object.entries(files).filter(([name]) => !left.has(new URL(name, page).href)));
}

/** The address of the page asks for this. */
export interface Request {
  readonly condition: Condition;
  readonly seed: number;
  readonly language: string;
  readonly details: boolean;
}

/** Reads scene.json. */
export async function description(url: string): Promise<Description> {
  const answer = await fetch(url);
  if (!answer.ok) {
    throw new Error(`${url} cannot be read (${answer.status}); the page needs all files of its folder`);
  }
  return parse(url, await answer.json());
}

/** Checks what scene.json holds. */
export function parse(url: string, json: unknown): Description {
  const found = json as Partial<Record<keyof Description, unknown>> | null;
  if (typeof found?.file !== 'string' || typeof found.controller !== 'string' || !isCondition(found.condition)) {
    throw new Error(`${url} does not describe a scene; export it anew`);
  }
  return {
    file: found.file,
    controller: found.controller,
    condition: found.condition,
    title: typeof found.title === 'string' ? found.title : found.file,
    seed: typeof found.seed === 'number' ? found.seed : 0,
    files: (found.files ?? {}) as Record<string, number>,
    later: (found.later ?? []) as LaterVersion[],
    normalMaps: found.normalMaps !== false,
  };
}

/** Reads the query of the page's address; what is not understood is as the scene was exported. */
export function request(query: string, exported: Description, language: string): Request {
  const asked = new URLSearchParams(query);
  const condition = asked.get('condition');
  const seed = asked.get('seed') ?? '';
  return {
    condition: isCondition(condition) ? condition : exported.condition,
    seed: /^-?\d{1,10}$/.test(seed) ? Number(seed) | 0 : exported.seed,
    language: asked.get('lang') ?? language,
    details: asked.get('details') === '1',
  };
}

function isCondition(value: unknown): value is Condition {
  return CONDITIONS.some((condition) => condition === value);
}
