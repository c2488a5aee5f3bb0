import { joined, parts, typed } from './answers.js';
import type { Field, Option, Wording } from './description.js';


type Changed = (value: string) => void;

let made = 0;

/** Makes an element with a text. */
export function element(tag: string, className = '', text = ''): HTMLElement {
  const made = document.createElement(tag);
  made.className = className;
  made.textContent = text;
  return made;
}

/**
 * Makes what a field is filled in with.
 *
 * @param label what assistive technology says of it
 * @param value the answer so far
 * @param changed called with each new answer
 */
export function fieldElement(field: Field, label: string, value: string, words: Wording, changed: Changed): HTMLElement {
  switch (field.type) {
    case 'choice':
      return choice(field, label, value, changed);
    case 'line':
      return line(field, label, value, words, changed);
    case 'slider':
      return slider(field, label, value, changed);
    case 'ranking':
      return ranking(field.options, label, value, words, changed);
  }
}

function choice(field: Field & { type: 'choice' }, label: string, value: string, changed: Changed): HTMLElement {
  const scale = [field.least, field.most].some(Boolean) || field.options.every((option) => option.note);
  const box = element('div', scale ? 'choice scale' : 'choice');
  box.setAttribute('role', field.several ? 'group' : 'radiogroup');
  box.setAttribute('aria-label', label);
  const name = `choice-${++made}`;
  if (field.least) {
    box.append(element('span', 'end least', field.least));
  }
  const inputs = field.options.map((option) => {
    const input = document.createElement('input');
    input.type = field.several ? 'checkbox' : 'radio';
    input.name = name;
    input.value = option.value;
    input.checked = parts(value).includes(option.value);
    input.addEventListener('change', () => {
      changed(joined(inputs.filter((each) => each.checked).map((each) => each.value)));
    });
    const around = element('label', 'option');
    around.append(input, labelOf(option));
    box.append(around);
    return input;
  });
  if (field.most) {
    box.append(element('span', 'end most', field.most));
  }
  return box;
}

function labelOf(option: Option): HTMLElement {
  const text = element('span', '', option.picture ? '' : option.label);
  if (option.picture) {
    const picture = document.createElement('img');
    picture.src = option.picture;
    picture.alt = option.label;
    text.append(picture);
  }
  if (option.note) {
    text.append(element('small', '', option.note));
  }
  return text;
}

function line(field: Field & { type: 'line' }, label: string, value: string, words: Wording, changed: Changed): HTMLElement {
  const box = element('div', 'line');
  const input = document.createElement(field.lines > 1 ? 'textarea' : 'input');
  if (input instanceof HTMLTextAreaElement) {
    input.rows = field.lines;
  } else if (field.range) {
    input.inputMode = 'decimal';
    input.size = 8;
  }
  input.value = value;
  input.setAttribute('aria-label', label);
  const fault = element('span', 'fault');
  fault.setAttribute('role', 'status');
  input.addEventListener('input', () => {
    const given = typed(field, input.value);
    const wrong = given === undefined && input.value.trim() !== '';
    fault.textContent = wrong && field.range ? words.of('web.not-allowed', field.range.least, field.range.most) : '';
    input.setAttribute('aria-invalid', String(wrong));
    changed(given ?? '');
  });
  box.append(input, field.unit ? element('span', 'unit', field.unit) : '', fault);
  return box;
}

function slider(field: Field & { type: 'slider' }, label: string, value: string, changed: Changed): HTMLElement {
  const box = element('div', 'slider');
  const input = document.createElement('input');
  input.type = 'range';
  input.min = '0';
  input.max = String(field.values.length - 1);
  input.step = '1';
  const at = field.values.indexOf(value);
  input.value = String(at >= 0 ? at : (field.start ?? Math.floor(field.values.length / 2)));
  input.classList.toggle('untouched', at < 0 && field.start === undefined);
  input.setAttribute('aria-label', label);
  const number = element('output', '', field.number && at >= 0 ? value : '');
  const set = (): void => {
    const now = field.values[Number(input.value)] ?? '';
    input.classList.remove('untouched');
    number.textContent = field.number ? now : '';
    changed(now);
  };
  input.addEventListener('input', set);
  // Who leaves the thumb where it is touches it.
  input.addEventListener('pointerup', set);
  input.addEventListener('keydown', (event) => {
    if (event.key === ' ') {
      event.preventDefault();
      set();
    }
  });
  box.append(element('span', 'end least', field.least ?? ''), input, element('span', 'end most', field.most ?? ''), number);
  return box;
}

function ranking(options: readonly Option[], label: string, value: string, words: Wording, changed: Changed): HTMLElement {
  const box = element('div', 'ranking');
  box.setAttribute('role', 'group');
  box.setAttribute('aria-label', label);
  const list = element('ol');
  let order = parts(value).flatMap((part) => options.filter((option) => option.value === part));
  if (order.length === 0) {
    order = [...options];
  }
  const tell = (): void => { changed(joined(order.map((option) => option.value))); };
  const draw = (): void => {
    list.replaceChildren(...order.map((option, i) => {
      const item = element('li', '', '');
      item.append(labelOf(option), mover('↑', 'web.up', option, i, -1), mover('↓', 'web.down', option, i, 1));
      return item;
    }));
  };
  const mover = (sign: string, key: string, option: Option, from: number, by: number): HTMLElement => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = sign;
    button.setAttribute('aria-label', words.of(key, option.label));
    button.disabled = from + by < 0 || from + by >= order.length;
    button.addEventListener('click', () => {
      order.splice(from + by, 0, ...order.splice(from, 1));
      draw();
      tell();
    });
    return button;
  };
  const right = document.createElement('button');
  right.type = 'button';
  right.textContent = words.of('web.order');
  right.addEventListener('click', tell);
  draw();
  box.append(list, right);
  return box;
}
