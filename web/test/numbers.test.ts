import { describe, expect, it } from 'vitest';
import { readNumbersFast, type ValueParser } from '../src/scene/numbers.js';

/** A parser as X_ITE's, whose own methods only tell that they were asked. */
class Parser implements ValueParser {
  lastIndex = 0;
  lineNumber = 1;
  value = NaN;
  asked = 0;
  constructor(public input: string) {}
  double(): boolean {
    this.asked++;
    return false;
  }
  int32(): boolean {
    this.asked++;
    return false;
  }
}

function parser(input: string): Parser {
  const made = new Parser(input);
  readNumbersFast(made);
  return made;
}

function read(made: Parser, kind: 'double' | 'int32'): number[] {
  const values: number[] = [];
  while (made[kind]()) {
    values.push(made.value);
  }
  return values;
}

describe('numbers in the text of a scene', () => {
  it('are read as JavaScript reads them', () => {
    const made = parser(' 1 -2.5,\t+3. .25\r\n-0.1\n123456789012345678 0.000001234]');
    expect(read(made, 'double')).toEqual([1, -2.5, 3, 0.25, -0.1, Number('123456789012345678'), 0.000001234]);
    expect(made.lineNumber).toBe(3);
    expect(made.input.charAt(made.lastIndex)).toBe(']');
  });

  it('may be whole', () => {
    expect(read(parser('0 1 2 -1\n+3, 4'), 'int32')).toEqual([0, 1, 2, -1, 3, 4]);
  });

  it.each(['1e-5', 'PI', '0xff', '# comment\n1', '', ' ', '-', '.', '1.5.2', 'true'])(
    'of another form (%s) are left to X_ITE, from where they stand',
    (text) => {
      const made = parser(` ${text}`);
      expect(made.double()).toBe(false);
      expect([made.asked, made.lastIndex, made.lineNumber]).toEqual([1, 0, 1]);
    },
  );

  it('that are whole end before a point', () => {
    const made = parser('1.5');
    expect(made.int32()).toBe(false);
    expect([made.asked, made.lastIndex]).toEqual([1, 0]);
  });
});
