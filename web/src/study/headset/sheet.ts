import { parts, joined } from '../answers.js';
import type { Field, Option } from '../description.js';

/** Pixels of the panel's picture. */
export const WIDTH = 1280;
export const HEIGHT = 960;

const MARGIN = 56;
const FONT = 'system-ui, sans-serif';
const INK = '#1b1f24';
const BLUE = '#1d5fa8';

/** What a ray can press: a rectangle of the picture, in pixels. */
export interface Target {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** What it is called, for programs that drive the panel. */
  readonly name: string;
  /** @param share 0 to 1 from the left side of the rectangle */
  readonly pressed: (share: number) => void;
}

/** What is written on a panel, from its top to its bottom. */
export class Sheet {
  readonly targets: Target[] = [];
  private y = MARGIN;

  /** @param scale of the letters; a sheet that is too full is made anew with smaller ones */
  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly scale: number,
    private readonly pictures: ReadonlyMap<string, HTMLImageElement>,
  ) {
    context.fillStyle = '#fff';
    context.fillRect(0, 0, WIDTH, HEIGHT);
  }

  /** Whether everything has its place above the buttons. */
  get fits(): boolean {
    return this.y <= HEIGHT - MARGIN - 110;
  }

  title(text: string): void {
    this.write(text, 46, true);
  }

  text(text: string, bold = false): void {
    this.write(text, 36, bold);
  }

  /** Writes a line that is to be noticed. */
  note(text: string): void {
    this.write(text, 36, true, '#a11');
  }

  picture(address: string): void {
    const picture = this.pictures.get(address);
    if (picture) {
      const height = 320 * this.scale;
      const width = Math.min((picture.width * height) / picture.height, WIDTH - 2 * MARGIN);
      this.context.drawImage(picture, MARGIN, this.y, width, height);
      this.y += height + 20;
    }
  }

  /** Draws a field; those of other types are not asked on panels. */
  field(field: Field, value: string, changed: (value: string) => void): void {
    if (field.type === 'choice') {
      this.choice(field, value, changed);
    } else if (field.type === 'slider') {
      this.slider(field, value, changed);
    }
  }

  /** Draws the buttons at the bottom. */
  buttons(...buttons: { readonly text: string; readonly pressed: () => void }[]): void {
    this.font(38, true);
    let x = MARGIN;
    for (const { text, pressed } of buttons) {
      const width = Math.max(220, this.context.measureText(text).width + 80);
      this.box({ x, y: HEIGHT - MARGIN - 90, width, height: 90, name: text, pressed }, BLUE);
      this.label(text, x + width / 2, HEIGHT - MARGIN - 45, '#fff');
      x += width + 30;
    }
  }

  private choice(field: Field & { type: 'choice' }, value: string, changed: (value: string) => void): void {
    const chosen = parts(value);
    const press = (option: Option): void => {
      if (!field.several) {
        changed(option.value);
        return;
      }
      const others = chosen.filter((each) => each !== option.value);
      const all = others.length < chosen.length ? others : [...chosen, option.value];
      changed(joined(field.options.map((each) => each.value).filter((each) => all.includes(each))));
    };
    const { length } = field.options;
    this.font(34, false);
    const room = (WIDTH - 2 * MARGIN) / length;
    const row = field.options.every(({ label, picture, note }) =>
      !picture && !note && this.context.measureText(label).width < room - 36);
    const columns = row ? length : Math.ceil(length / 8);
    const width = (WIDTH - 2 * MARGIN) / columns;
    const pictured = field.options.some(({ picture }) => picture !== undefined);
    const height = (pictured ? 150 : 76) * this.scale;
    this.ends(field);
    field.options.forEach((option, i) => {
      const lines = Math.ceil(length / columns);
      const [x, y] = [MARGIN + Math.floor(i / lines) * width, this.y + (i % lines) * height];
      const on = chosen.includes(option.value);
      const target = { x: x + 4, y: y + 4, width: width - 8, height: height - 8, name: option.label, pressed: () => { press(option); } };
      this.box(target, on ? BLUE : '#eef1f5');
      const picture = option.picture === undefined ? undefined : this.pictures.get(option.picture);
      if (picture) {
        const high = height - 24;
        this.context.drawImage(picture, x + 12, y + 12, Math.min((picture.width * high) / picture.height, width - 24), high);
      } else {
        const text = option.note ? `${option.label} – ${option.note}` : option.label;
        this.label(text, row ? x + width / 2 : x + 32, y + height / 2, on ? '#fff' : INK, row ? 'center' : 'left', width - 48);
      }
    });
    this.y += Math.ceil(length / columns) * height + 20;
  }

  private slider(field: Field & { type: 'slider' }, value: string, changed: (value: string) => void): void {
    const { values } = field;
    const width = WIDTH - 2 * MARGIN;
    const height = 110 * this.scale;
    this.ends(field);
    const at = values.indexOf(value);
    this.box({
      x: MARGIN,
      y: this.y,
      width,
      height,
      name: 'slider',
      pressed: (share) => { changed(values[Math.min(values.length - 1, Math.floor(share * values.length))] ?? ''); },
    }, '#eef1f5');
    this.context.fillStyle = '#9aa4b0';
    this.context.fillRect(MARGIN + 20, this.y + height / 2 - 4, width - 40, 8);
    if (at >= 0) {
      this.context.fillStyle = BLUE;
      this.context.beginPath();
      this.context.arc(MARGIN + ((at + 0.5) * width) / values.length, this.y + height / 2, height * 0.3, 0, 2 * Math.PI);
      this.context.fill();
    }
    this.y += height + 10;
    if (field.number && at >= 0) {
      this.text(value, true);
    }
  }

  /** Writes what the ends of a scale mean, above it. */
  private ends({ least, most }: { readonly least?: string; readonly most?: string }): void {
    if (least === undefined && most === undefined) {
      return;
    }
    this.font(30, false);
    this.label(least ?? '', MARGIN, this.y + 16, INK, 'left', WIDTH / 2 - MARGIN - 20);
    this.label(most ?? '', WIDTH - MARGIN, this.y + 16, INK, 'right', WIDTH / 2 - MARGIN - 20);
    this.y += 46 * this.scale;
  }

  private box(target: Target, fill: string): void {
    this.targets.push(target);
    this.context.fillStyle = fill;
    this.context.beginPath();
    this.context.roundRect(target.x, target.y, target.width, target.height, 10);
    this.context.fill();
  }

  private label(text: string, x: number, y: number, ink: string, align: CanvasTextAlign = 'center', most = WIDTH): void {
    this.context.fillStyle = ink;
    this.context.textAlign = align;
    this.context.textBaseline = 'middle';
    this.context.fillText(text, x, y, most);
  }

  private write(text: string, size: number, bold: boolean, ink = INK): void {
    this.font(size, bold);
    const step = size * this.scale * 1.35;
    for (const paragraph of text.split('\n').filter((each) => each !== '')) {
      for (const line of this.lines(paragraph)) {
        this.label(line, MARGIN, this.y + step / 2, ink, 'left', WIDTH - 2 * MARGIN);
        this.y += step;
      }
    }
    this.y += 12 * this.scale;
  }

  /** Breaks a paragraph into lines that the sheet is wide enough for. */
  private lines(paragraph: string): string[] {
    const lines: string[] = [];
    let line = '';
    for (const word of paragraph.split(' ')) {
      const longer = line === '' ? word : `${line} ${word}`;
      if (line !== '' && this.context.measureText(longer).width > WIDTH - 2 * MARGIN) {
        lines.push(line);
        line = word;
      } else {
        line = longer;
      }
    }
    return [...lines, line];
  }

  private font(size: number, bold: boolean): void {
    this.context.font = `${bold ? 'bold ' : ''}${Math.round(size * this.scale)}px ${FONT}`;
  }
}
