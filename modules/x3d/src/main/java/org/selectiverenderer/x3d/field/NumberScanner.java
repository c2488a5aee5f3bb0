package org.selectiverenderer.x3d.field;

/** Reads the numbers of a value into a buffer that is reused for the next value. */
abstract class NumberScanner {
  /** Numbers read by one call; HotSpot switches to compiled code at a call, not within a loop. */
  private static final int BLOCK = 256;

  private int capacity;

  /** The index after the last number that {@link #plain} has read. */
  int next;

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
    int at = start;
    while (true) {
      int before = count;
      at = plain(text, at, end, count, Math.min(capacity, count + BLOCK));
      count = next;
      at = FieldTokenizer.skipSeparators(text, at, end);
      if (at == end) {
        return count;
      }
      if (count == capacity) {
        capacity *= 2;
        grow(capacity);
      } else if (count - before < BLOCK) {
        at = number(text, start, at, end, count++, flaws);
      }
    }
  }

  /**
   * Reads numbers of the usual form up to the first of another form, and sets {@link #next}. May
   * read none.
   *
   * @param index the index of the first number in the buffer
   * @param stop the index before which to stop
   * @return the offset after the last number read
   */
  int plain(char[] text, int at, int end, int index, int stop) {
    next = index;
    return at;
  }

  /** Enlarges the buffer. */
  abstract void grow(int wanted);

  /**
   * Reads one number of any form and returns the offset after it.
   *
   * @param start the offset of the value, from which offsets of errors count
   * @param word the offset of the number
   * @param end the offset after the value
   * @param index the index in the buffer
   */
  abstract int number(char[] text, int start, int word, int end, int index, FieldParseErrors flaws);
}
