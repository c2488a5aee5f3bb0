import type { Jatos } from '../data/jatos-sink.js';

declare global {
  interface Window {
    jatos?: Jatos;
  }
}

/** Loads jatos.js, which JATOS serves beside the page, and returns it when it is ready. */
export async function loadJatos(): Promise<Jatos> {
  const script = document.createElement('script');
  script.src = 'jatos.js';
  const loaded = new Promise<void>((resolve, reject) => {
    script.addEventListener('load', () => { resolve(); });
    script.addEventListener('error', () => {
      reject(new Error('jatos.js cannot be loaded: with "receiver": "jatos" in study-settings.json only JATOS runs this page'));
    });
  });
  document.head.append(script);
  await loaded;
  const { jatos } = window;
  if (!jatos) {
    throw new Error('jatos.js does not offer what its reference tells');
  }
  await new Promise<void>((ready) => { jatos.onLoad(ready); });
  return jatos;
}

/** Returns the query of the address that led to JATOS, which has another one for the page itself. */
export function queryOf(jatos: Jatos): string {
  const named = Object.entries(jatos.urlQueryParameters ?? {})
    .flatMap(([name, value]) => (typeof value === 'string' ? [[name, value]] : []));
  return `?${new URLSearchParams(named).toString()}`;
}
