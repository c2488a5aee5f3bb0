package org.selectiverenderer.x3d.field;

/** Reads the numbers of a value into a buffer that is reused for the next value. */
abstract class NumberScanner {
  private int capacity;

  /**
   * Creates a scanner.
   *
   * @param capacity the initial capacity of the buffer
   */
  NumberScanner(int capacity) {
    this.capacity = capacity;
  }

  /** Reads all numbers and returns how many there are. */
  final int scan(char[] text, int start, int end, FieldParseErrors flaws) {
    int count = 0;
    for (int at = FieldTokenizer.skipSeparators(text, start, end);
        at < end;
        at = FieldTokenizer.skipSeparators(text, at, end)) {
      if (count == capacity) {
        capacity *= 2;
        grow(capacity);
      }
      at = number(text, start, at, end, count++, flaws);
    }
    return count;
  }

  /** Enlarges the buffer. */
  abstract void grow(int wanted);

  /**
   * Reads one number and returns the offset after it. This is a method of its own, since HotSpot
   * switches to compiled code much sooner at a new call than within a loop over a whole file.
   *
   * @param start the offset of the value, from which offsets of errors count
   * @param word the offset of the number
   * @param end the offset after the value
   * @param index the index in the buffer
   */
  abstract int number(char[] text, int start, int word, int end, int index, FieldParseErrors flaws);
}
