package org.selectiverenderer.x3d.source;

import java.util.Arrays;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;

/**
 * A text in an encoding other than XML, from which elements have been built. The locations of their
 * attributes are stored in an array, which is sorted when the first location is needed, for an
 * error.
 */
final class NonXmlSource implements ElementSource {
  private static final int NUMBERS = 4;

  private final TextSource text;
  private final SourceText characters;
  private final ValueCommentStripper cleaner;
  private int[] places = new int[256];
  private int count;
  private long[] order = {};

  NonXmlSource(TextSource text, SourceText characters, ValueCommentStripper cleaner) {
    this.text = text;
    this.characters = characters;
    this.cleaner = cleaner;
  }

  /**
   * Records the next attribute of an element.
   *
   * @param element the offset of the element
   */
  void note(int element, int name, int from, int to) {
    if ((count + 1) * NUMBERS > places.length) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    int at = NUMBERS * count++;
    places[at] = element;
    places[at + 1] = name;
    places[at + 2] = from;
    places[at + 3] = to;
  }

  /** Copies characters, replacing those that are not part of the value by blanks. */
  void copy(int from, int to, char[] into) {
    for (int i = from; i < to; i++) {
      into[i - from] = characters.charAt(i);
    }
    cleaner.clean(into, to - from);
  }

  /** Returns a value's characters, with those that are not part of it replaced by blanks. */
  String value(int from, int to) {
    char[] copy = new char[to - from];
    copy(from, to, copy);
    return new String(copy);
  }

  private int find(int element, int index) {
    if (order.length != count) {
      long[] sorted = new long[count];
      for (int i = 0; i < count; i++) {
        sorted[i] = (long) places[NUMBERS * i] << Integer.SIZE | i;
      }
      Arrays.sort(sorted);
      order = sorted;
    }
    int first = Arrays.binarySearch(order, (long) element << Integer.SIZE);
    int at = (first < 0 ? -first - 1 : first) + index;
    boolean there = at < count && order[at] >>> Integer.SIZE == element;
    return there ? NUMBERS * (int) order[at] : -1;
  }

  @Override
  public SourceLocation attribute(int element, int index) {
    int at = find(element, index);
    return location(at < 0 ? element : places[at + 1]);
  }

  @Override
  public SourceLocation inAttribute(int element, int index, int character) {
    int at = find(element, index);
    return location(at < 0 ? element : Math.min(places[at + 2] + character, places[at + 3]));
  }

  @Override
  public String attributeText(int element, int index) {
    int at = find(element, index);
    return at < 0 ? "" : value(places[at + 2], places[at + 3]);
  }

  @Override
  public String attributeLines(int element, int index) {
    return attributeText(element, index);
  }

  @Override
  public String file() {
    return text.file();
  }

  @Override
  public CharSequence characters() {
    return characters;
  }

  @Override
  public SourceLocation location(int offset) {
    return text.location(offset);
  }

  @Override
  public FieldParser parser() {
    return text.parser();
  }
}
