import { Headset } from '../scene/headset.js';
import { Input } from '../scene/input.js';
import { Walker } from '../scene/walker.js';
import { CONDITIONS, World, type Condition } from '../scene/world.js';
import { description, firstFiles, request, type Description, type Request } from './description.js';
import { Details } from './details.js';
import { Progress } from './progress.js';
import { words, type Words } from './words.js';

declare global {
  interface Window {
    /** The scene of the page and what walks in it, once it is shown, for programs that drive the page. */
    selectiveRenderer?: { readonly world: World; readonly walker: Walker; readonly headset?: Headset | undefined };
  }
}

function element(id: string): HTMLElement;
function element<T extends HTMLElement>(id: string, type: new () => T): T;
function element(id: string, type: new () => HTMLElement = HTMLElement): HTMLElement {
  const found = document.getElementById(id);
  if (!(found instanceof type)) {
    throw new Error(`the page lacks the element ${id}`);
  }
  return found;
}

async function show(): Promise<void> {
  const status = element('status');
  let text: Words = words(navigator.language);
  try {
    const exported = await description('scene.json');
    const asked = request(location.search, exported, navigator.language);
    text = words(asked.language);
    document.documentElement.lang = asked.language.toLowerCase().startsWith('el') ? 'el' : 'en';
    document.title = exported.title;
    const world = await open(exported, asked, text, status);
    status.hidden = true;
    const details = new Details(element('details'), world, text);
    controls(world, asked, text);
    const input = new Input(element('scene'), new AbortController().signal);
    const walker = new Walker(world, input);
    const headset = await Headset.find(element('scene'), world.browser);
    if (headset) {
      wearing(headset, world, text);
    }
    window.selectiveRenderer = { world, walker, headset };
    await walk(world, walker, input, details);
  } catch (error) {
    status.hidden = false;
    status.classList.add('failed');
    status.textContent = `${text.failed} ${error instanceof Error ? error.message : String(error)}`;
  }
}

async function open(exported: Description, asked: Request, text: Words, status: HTMLElement): Promise<World> {
  const loaded = new AbortController();
  new Progress(firstFiles(exported), location.href, (percent) => { status.textContent = text.loading(percent); })
    .follow(loaded.signal);
  try {
    return await World.open(element('scene'), exported, asked);
  } finally {
    loaded.abort();
  }
}

/** So many frames after the last step, what nobody has seen yet is loaded: reading a large model halts the picture. */
const QUIET = 30;

async function walk(world: World, walker: Walker, input: Input, details: Details): Promise<void> {
  const hint = element('hint');
  let still = 0;
  let loading = false;
  for (;;) {
    await world.nextFrame();
    walker.move();
    details.frame();
    const intent = input.intent();
    const moves = intent.forward !== 0 || intent.sideways !== 0;
    if (moves) {
      hint.hidden = true;
    }
    still = moves || intent.turning !== 0 ? 0 : still + 1;
    if (still > QUIET && !loading) {
      loading = true;
      void world.loadNext().then((more) => { loading = !more; });
    }
  }
}

function controls(world: World, asked: Request, text: Words): void {
  const touch = window.matchMedia('(pointer: coarse)').matches;
  element('hint').textContent = touch ? text.walkByTouch : text.walk;

  const condition = element('condition', HTMLSelectElement);
  condition.setAttribute('aria-label', text.condition);
  condition.append(...CONDITIONS.map((name) => new Option(text.conditions[name], name, false, name === asked.condition)));
  condition.addEventListener('change', () => { world.setCondition(condition.value as Condition, asked.seed); });

  const viewpoint = element('viewpoint', HTMLSelectElement);
  const views = world.viewpoints();
  viewpoint.hidden = views.length < 2;
  viewpoint.append(new Option(text.viewpoint, ''), ...views.map((name, i) => new Option(name, String(i))));
  viewpoint.setAttribute('aria-label', text.viewpoint);
  viewpoint.addEventListener('change', () => {
    if (viewpoint.value !== '') {
      world.visit(Number(viewpoint.value));
      viewpoint.value = '';
      viewpoint.blur(); // the arrow keys walk again
    }
  });

  const details = element('details');
  details.hidden = !asked.details;
  const toggle = element('toggle-details', HTMLButtonElement);
  toggle.textContent = text.details;
  const flip = (): void => {
    details.hidden = !details.hidden;
    toggle.setAttribute('aria-pressed', String(!details.hidden));
  };
  toggle.setAttribute('aria-pressed', String(!details.hidden));
  toggle.addEventListener('click', flip);
  document.addEventListener('keydown', (event) => {
    if (event.key === 'F1') {
      event.preventDefault();
      flip();
    }
  });

  const full = element('full-screen', HTMLButtonElement);
  full.textContent = text.fullScreen;
  full.hidden = !document.fullscreenEnabled;
  full.addEventListener('click', () => {
    void (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());
  });

  element('bar').hidden = false;
}

/** Offers the headset. */
function wearing(headset: Headset, world: World, text: Words): void {
  const button = element('headset', HTMLButtonElement);
  const status = element('status');
  button.textContent = text.headset;
  button.hidden = false;
  button.addEventListener('click', () => {
    status.hidden = true;
    headset.enter(world.walker().eyes).catch((error: unknown) => {
      status.hidden = false;
      status.textContent = `${text.headsetFailed} ${error instanceof Error ? error.message : String(error)}`;
    });
  });
  headset.listen({ worn: () => { world.wear(headset); }, left: () => { world.wear(undefined); } });
}

void show();
