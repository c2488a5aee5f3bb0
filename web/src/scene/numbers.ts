/** X_ITE's parser of values in text knows its place in the text, and the last number that it has read. */
export interface ValueParser {
  input: string;
  lastIndex: number;
  lineNumber: number;
  value: number;
  /** Reads a number after white space and comments; returns whether there is one. */
  double: (this: ValueParser) => boolean;
  int32: (this: ValueParser) => boolean;
}

const TAB = 9;
const LINE_FEED = 10;
const RETURN = 13;
const SPACE = 32;
const PLUS = 43;
const COMMA = 44;
const MINUS = 45;
const POINT = 46;
const ZERO = 48;
const NINE = 57;
/** The closing bracket of VRML's lists. */
const BRACKET = 93;

/** So many digits of a whole number are exact in JavaScript's numbers. */
const EXACT_DIGITS = 15;

/**
 * Makes a parser read plain decimal numbers without regular expressions, of which X_ITE uses five for each number: a
 * model has hundreds of thousands. Anything else, such as a comment, a constant or a hexadecimal number, is left to
 * the parser's own methods.
 */
export function readNumbersFast(parser: ValueParser): void {
  const { double, int32 } = parser;
  parser.double = function (this: ValueParser) {
    return scan(this, true) || double.call(this);
  };
  parser.int32 = function (this: ValueParser) {
    return scan(this, false) || int32.call(this);
  };
}

/** Reads a plain number; false, with the parser where it was, for anything else. */
function scan(parser: ValueParser, fractions: boolean): boolean {
  const text = parser.input;
  let at = parser.lastIndex;
  let lines = 0;
  let code = text.charCodeAt(at);
  for (; separates(code); code = text.charCodeAt(++at)) {
    lines += code === LINE_FEED ? 1 : 0;
  }
  const start = at;
  if (code === MINUS || code === PLUS) {
    code = text.charCodeAt(++at);
  }
  const first = at;
  let whole = 0;
  for (; digit(code); code = text.charCodeAt(++at)) {
    whole = whole * 10 + (code - ZERO);
  }
  const integer = at;
  let digits = integer - first;
  if (fractions && code === POINT) {
    for (code = text.charCodeAt(++at); digit(code); code = text.charCodeAt(++at)) {
      digits++;
    }
  }
  if (digits === 0 || !(separates(code) || code === BRACKET || Number.isNaN(code))) {
    return false;
  }
  const exact = at === integer && digits <= EXACT_DIGITS;
  parser.value = exact ? (text.charCodeAt(start) === MINUS ? -whole : whole) : Number(text.slice(start, at));
  parser.lastIndex = at;
  parser.lineNumber += lines;
  return true;
}

function digit(code: number): boolean {
  return code >= ZERO && code <= NINE;
}

/** Returns whether a character is white space or a comma, which stand between values. */
function separates(code: number): boolean {
  return code === SPACE || code === COMMA || code === LINE_FEED || code === RETURN || code === TAB;
}
