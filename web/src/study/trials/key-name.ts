const NAMED: Readonly<Record<string, string>> = {
  ' ': 'space',
  'Enter': 'enter',
  'ArrowLeft': 'left',
  'ArrowRight': 'right',
  'ArrowUp': 'up',
  'ArrowDown': 'down',
};

/**
 * Returns the name that studies have for a key: a letter, a digit, space, enter, left, right, up, down; empty for others.
 * On a keyboard whose letters are not Latin the key counts that has the letter on an English one.
 */
export function keyName(event: Pick<KeyboardEvent, 'key' | 'code'>): string {
  const named = NAMED[event.key];
  if (named !== undefined) {
    return named;
  }
  const key = event.key.toLowerCase();
  return /^[a-z0-9]$/.test(key) ? key : (/^(?:Key|Digit|Numpad)([A-Z0-9])$/.exec(event.code)?.[1] ?? '').toLowerCase();
}
