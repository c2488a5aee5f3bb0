package org.selectiverenderer.x3d.write;

/** Many numbers of one value, separated by blanks and, where a line is full, by line ends. */
public final class TupleLines {
  private final StringBuilder text;
  private final int perLine;
  private final int width;
  private int count;
  private int line;

  private TupleLines(StringBuilder text, int perLine, int width) {
    this.text = text;
    this.perLine = perLine;
    this.width = width;
    line = text.length();
  }

  /** Lines of so many tuples each. */
  public static TupleLines perLine(int tuples) {
    return new TupleLines(new StringBuilder(), tuples, Integer.MAX_VALUE);
  }

  /** Lines that end with the tuple by which they have so many characters. */
  public static TupleLines wide(int characters) {
    return new TupleLines(new StringBuilder(), Integer.MAX_VALUE, characters);
  }

  /** Separates from what was before; the next tuple is to be appended to what is returned. */
  public StringBuilder next() {
    if (count > 0) {
      boolean full = count % perLine == 0 || text.length() - line >= width;
      text.append(full ? '\n' : ' ');
      line = full ? text.length() : line;
    }
    count++;
    return text;
  }

  /** Triangles as a coordIndex and its like have them, each ended by -1. */
  public TupleLines triangles(int[] corners) {
    for (int i = 0; i < corners.length; i += 3) {
      next().append(corners[i]).append(' ').append(corners[i + 1]).append(' ');
      text.append(corners[i + 2]).append(" -1");
    }
    return this;
  }

  public StringBuilder text() {
    return text;
  }
}
