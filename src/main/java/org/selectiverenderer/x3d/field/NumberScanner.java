package org.selectiverenderer.x3d.field;

/** Reads the numbers of a value, one after the other, into a buffer that is kept between values. */
abstract class NumberScanner {
  private int capacity;

  /**
   * @param capacity of the buffer
   */
  NumberScanner(int capacity) {
    this.capacity = capacity;
  }

  /** Reads all numbers and returns how many there are. */
  final int scan(char[] text, int start, int end, Flaws flaws) {
    int count = 0;
    for (int at = Tokens.skipSeparators(text, start, end);
        at < end;
        at = Tokens.skipSeparators(text, at, end)) {
      if (count == capacity) {
        capacity *= 2;
        grow(capacity);
      }
      at = number(text, start, at, end, count++, flaws);
    }
    return count;
  }

  /** Makes room in the buffer. */
  abstract void grow(int wanted);

  /**
   * Reads one number and returns where it ends. A method of its own, since the virtual machine
   * takes compiled code for a new call much sooner than within a loop that runs for a whole file.
   *
   * @param start of the value, from which flaws count
   * @param word where the number starts
   * @param end of the value
   * @param index in the buffer
   */
  abstract int number(char[] text, int start, int word, int end, int index, Flaws flaws);
}
