import { HttpSink } from '../data/http-sink.js';
import { JatosSink, type Jatos } from '../data/jatos-sink.js';
import { uuid } from '../data/session.js';
import type { DataSink } from '../data/sink.js';
import { WaitingPage } from '../data/waiting-page.js';
import { dataWords } from '../data/words.js';
import type { Study } from './description.js';
import { StepsPlace, type KeptSteps } from './kept-steps.js';
import { RecordFile } from './record-file.js';
import { askedSlot, type Settings } from './settings.js';

/** A participant's session: where its data go, which place of the plan it has, and how far it was. */
export interface Session {
  readonly id: string;
  readonly sink: DataSink;
  /**
   * Takes the session's place in the plan, from 0, the same each time; undefined if all are taken. Who cannot take part
   * is to know before.
   */
  readonly take: () => Promise<number | undefined>;
  readonly place: StepsPlace;
  readonly kept: KeptSteps | undefined;
  /** Whether the participant was at the end already. */
  readonly ended: boolean;
  /** Whether data outlive a closed page. */
  readonly lasting: boolean;
}

/**
 * Begins a session, or goes on with the one that a closed page left.
 *
 * @param waiting the element that tells of data on their way
 * @param participant whom the recruitment sends, such as PROLIFIC_PID; empty if nobody says
 * @param jatos jatos.js where the receiver is JATOS
 */
export async function open(
  study: Study,
  settings: Settings,
  query: string,
  waiting: HTMLElement,
  language: string,
  participant: string,
  jatos?: Jatos,
): Promise<Session> {
  const asked = askedSlot(query, study.slots.length);
  if (settings.receiver === '') {
    // Nobody counts the places: who tries the study out names one, or gets any.
    const slot = Promise.resolve(asked ?? Math.floor(Math.random() * study.slots.length));
    const id = uuid();
    return { id, sink: new RecordFile(), take: () => slot, place: new StepsPlace(undefined, id), kept: undefined, ended: false, lasting: false };
  }
  const storage = ownStorage();
  const keeping = {
    study: study.name,
    waiting: new WaitingPage(waiting, dataWords(language)),
    indexedDB: window.indexedDB,
    localStorage: storage,
    events: window,
  };
  const sink = jatos
    ? await JatosSink.open(jatos, keeping)
    : await HttpSink.open({ ...keeping, url: settings.receiver, participant });
  const place = new StepsPlace(storage, sink.session);
  return {
    id: sink.session,
    sink,
    take: async () => {
      const taken = asked === undefined ? await sink.slot(study.slots.length) : asked + 1; // a receiver counts places from 1
      return taken === undefined ? undefined : taken - 1;
    },
    place,
    kept: sink.resumed ? place.read() : undefined,
    ended: sink.ended,
    lasting: sink.lasting,
  };
}

/** Returns the page's storage; a browser that forbids it throws. */
function ownStorage(): Storage | undefined {
  try {
    return window.localStorage;
  } catch {
    return undefined;
  }
}
