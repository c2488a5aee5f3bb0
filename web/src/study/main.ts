import browserCheck from '@jspsych/plugin-browser-check';
import fullscreen from '@jspsych/plugin-fullscreen';
import htmlButtonResponse from '@jspsych/plugin-html-button-response';
import { initJsPsych } from 'jspsych';
import { dataWords } from '../data/words.js';
import { Headset } from '../scene/headset.js';
import { parse, Wording, type Slot, type Study } from './description.js';
import { escaped } from './escape.js';
import { element as make } from './fields.js';
import { RecordFile } from './record-file.js';
import { Recorder } from './recorder.js';
import { loadJatos, queryOf } from './jatos.js';
import { lastPage } from './last-page.js';
import { open, type Session } from './session.js';
import { JATOS, completion, language, recruitment, settings, type Settings } from './settings.js';
import { sceneCheckPlugin, shows } from './scene-check.js';
import { Stage } from './stage.js';
import { timeline } from './steps.js';

function element(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`the page lacks the element ${id}`);
  }
  return found;
}

async function json(url: string): Promise<unknown> {
  const answer = await fetch(url, { cache: 'no-cache' });
  if (!answer.ok) {
    throw new Error(`${url} cannot be read (${answer.status}); the page needs all files of its folder`);
  }
  return answer.json();
}

function failed(error: unknown, sentence = ''): void {
  const message = error instanceof Error ? error.message : String(error);
  element('stage').style.visibility = 'hidden';
  const told = make('p', 'fault', `${sentence} ${message}`.trim());
  told.setAttribute('role', 'alert');
  element('message').replaceChildren(told);
  element('study').hidden = true;
}

async function run(): Promise<void> {
  const study = parse(await json('study-web.json'));
  document.title = study.name;
  const lab = settings(await json('study-settings.json'));
  if (lab.headset !== 'no' && Object.values(study.steps).some((step) => step.kind === 'block')) {
    throw new Error('study-settings.json: "headset" must be "no", as the page cannot show blocks of trials in a headset yet');
  }
  const headset = lab.headset !== 'no' && await Headset.known();
  if (lab.headset === 'require' && !headset) {
    // Said before a place of the plan is taken.
    const first = study.texts[language(location.search, navigator.languages, study.languages)];
    element('message').replaceChildren(make('p', '', new Wording(first?.words ?? {}).of('web.headset.required')));
    return;
  }
  const jatos = lab.receiver === JATOS ? await loadJatos() : undefined;
  const query = jatos ? queryOf(jatos) : location.search;
  const ids = recruitment(query);
  const wanted = language(query, navigator.languages, study.languages);
  const session = await open(study, lab, query, element('message'), wanted, Object.values(ids).join(' '), jatos);
  const spoken = session.kept?.language ?? wanted;
  const texts = study.texts[spoken];
  if (!texts) {
    throw new Error(`study-web.json has no texts in ${spoken}; export the study anew`);
  }
  document.documentElement.lang = spoken;
  const words = new Wording(texts.words);
  if (session.ended) {
    await finish(session, lab, ids, words);
  } else if (!document.createElement('canvas').getContext('webgl2') && Object.keys(study.scenes).length > 0) {
    element('message').replaceChildren(make('p', 'fault', words.of('web.no-graphics')));
  } else {
    await takePart(study, lab, ids, session, spoken, words);
  }
}

/** Checks the device, takes a place of the plan, and runs the session of a participant. */
async function takePart(
  study: Study,
  lab: Settings,
  ids: Readonly<Record<string, string>>,
  session: Session,
  spoken: string,
  words: Wording,
): Promise<void> {
  window.addEventListener('unhandledrejection', (event) => { failed(event.reason, words.of('web.failed')); });
  const stage = new Stage(element('stage'), element('scene'), element('curtain'), study.scenes, study.mute === true);
  const headset = lab.headset !== 'no' && await stage.findHeadset() ? lab.headset : 'no';
  const device = await check(study, lab, session, stage, spoken, words);
  // Not before: who cannot take part takes no place.
  const place = device && await session.take();
  const slot = place === undefined ? undefined : study.slots[place];
  if (slot) {
    await ask(study, lab, ids, session, slot, spoken, words, stage, headset, device ?? {});
  } else if (device) {
    element('study').hidden = true;
    element('message').replaceChildren(make('p', '', words.of('web.full')));
  }
}

/** Welcomes, and checks window, screen and how fast the scene is drawn; returns what is known of the device. */
async function check(
  study: Study,
  lab: Settings,
  session: Session,
  stage: Stage,
  spoken: string,
  words: Wording,
): Promise<Record<string, unknown> | undefined> {
  let device: Record<string, unknown> = {};
  const passed = { all: false };
  const jsPsych = initJsPsych({ display_element: 'study' });
  await jsPsych.run([
    {
      type: browserCheck,
      skip_features: ['webcam', 'microphone', 'webaudio'],
      minimum_width: lab.minWidth,
      minimum_height: lab.minHeight,
      window_resize_message: `<p>${escaped(words.of('web.small', lab.minWidth, lab.minHeight))}</p>`,
      resize_fail_button_text: escaped(words.of('web.small.end')),
      inclusion_function: (data: { vsync_rate: number }) => data.vsync_rate >= lab.minRefresh,
      exclusion_message: () => `<p>${escaped(words.of('web.unfit'))}</p>`,
      on_finish: (data: Record<string, unknown>) => {
        const { browser, browser_version, mobile, os, vsync_rate, width, height } = data;
        device = { browser, browser_version, mobile, os, vsync_rate, width, height };
      },
    },
    {
      type: htmlButtonResponse,
      stimulus: [words.of('web.welcome'), ...(session.lasting || lab.receiver === '' ? [] : [dataWords(spoken).notKept])]
        .map((line) => `<p>${escaped(line)}</p>`).join(''),
      choices: [escaped(words.of('web.begin'))],
      on_finish: () => { passed.all = true; },
    },
    ...(lab.fullScreen && document.fullscreenEnabled
      ? [{
          type: fullscreen,
          message: `<p>${escaped(words.of('web.full-screen'))}</p>`,
          button_label: escaped(words.of('next')),
        }]
      : []),
    ...(shows(study)
      ? [{
          type: sceneCheckPlugin(study, stage, words, lab.minFrameRate, (rate) => {
            device = { ...device, scene_rate: rate };
          }),
        }]
      : []),
  ] as never);
  return passed.all ? device : undefined;
}

/** Runs the steps of a session. */
async function ask(
  study: Study,
  lab: Settings,
  ids: Readonly<Record<string, string>>,
  session: Session,
  slot: Slot,
  spoken: string,
  words: Wording,
  stage: Stage,
  headset: Settings['headset'],
  device: Readonly<Record<string, unknown>>,
): Promise<void> {
  const texts = study.texts[spoken];
  if (!texts) {
    return;
  }
  const recorder = new Recorder(
    {
      study: study.name,
      checksum: study.checksum,
      session: session.id,
      slot: slot.slot + 1,
      participant: slot.participant,
      group: slot.group,
      condition: slot.condition,
      language: spoken,
    },
    session.sink,
  );
  const jsPsych = initJsPsych({
    display_element: 'study',
    on_interaction_data_update: (data: { event: string }) => { recorder.interrupted(data.event); },
  });
  const done = [...(session.kept?.done ?? [])];
  const wrong = [...(session.kept?.wrong ?? [])];
  const outcome = { refused: false };
  const keep = (step: string): void => { session.place.write({ language: spoken, done, wrong, open: step }); };
  stage.interrupted = (event) => { recorder.interrupted(event); };
  const steps = timeline({
    study,
    headset,
    slot,
    texts,
    words,
    stage,
    recorder,
    repeated: session.kept?.open ?? '',
    first: () => ({ recruitment: ids, device }),
    begun: keep,
    done,
    wrong,
    ended: (step, correct) => {
      done.push(step);
      if (correct === false) {
        wrong.push(step);
      }
      keep('');
    },
    refused: () => {
      outcome.refused = true;
      jsPsych.abortExperiment();
    },
  });
  await jsPsych.run(steps as never);
  await stage.leave();
  if (document.fullscreenElement) {
    await document.exitFullscreen();
  }
  if (outcome.refused) {
    element('study').hidden = true;
    await session.sink.finish();
    session.place.forget();
    element('message').replaceChildren(make('p', '', words.of('web.refused')));
  } else if (slot.steps.every((step) => done.includes(step))) {
    await finish(session, lab, ids, words);
  }
}

/** Waits until the data are where they belong, and thanks. */
async function finish(session: Session, lab: Settings, ids: Readonly<Record<string, string>>, words: Wording): Promise<void> {
  element('study').hidden = true;
  await session.sink.finish();
  session.place.forget();
  const unsaved = session.sink instanceof RecordFile ? { file: session.sink, name: `${session.id}.jsonl` } : undefined;
  const leads = lab.completion === '' ? '' : completion(lab.completion, ids);
  element('message').replaceChildren(lastPage(words, leads, unsaved));
}

run().catch((error: unknown) => { failed(error); });
