package org.selectiverenderer.x3d.write;

/** Builds the text of a long field value of tuples, separated by blanks and line breaks. */
public final class TupleListBuilder {
  private final StringBuilder text;
  private final int perLine;
  private final int width;
  private int count;
  private int line;

  private TupleListBuilder(StringBuilder text, int perLine, int width) {
    this.text = text;
    this.perLine = perLine;
    this.width = width;
    line = text.length();
  }

  /** Returns a builder that breaks the line after every {@code tuples} tuples. */
  public static TupleListBuilder perLine(int tuples) {
    return new TupleListBuilder(new StringBuilder(), tuples, Integer.MAX_VALUE);
  }

  /** Returns a builder that breaks a line after the tuple that reaches {@code characters}. */
  public static TupleListBuilder wide(int characters) {
    return new TupleListBuilder(new StringBuilder(), Integer.MAX_VALUE, characters);
  }

  /** Appends a separator and returns the text, to which the caller appends the next tuple. */
  public StringBuilder next() {
    if (count > 0) {
      boolean full = count % perLine == 0 || text.length() - line >= width;
      text.append(full ? '\n' : ' ');
      line = full ? text.length() : line;
    }
    count++;
    return text;
  }

  /** Appends triangles in the form of a coordIndex, each followed by -1. */
  public TupleListBuilder triangles(int[] corners) {
    for (int i = 0; i < corners.length; i += 3) {
      next().append(corners[i]).append(' ').append(corners[i + 1]).append(' ');
      text.append(corners[i + 2]).append(" -1");
    }
    return this;
  }

  /** Returns the text. */
  public StringBuilder text() {
    return text;
  }
}
