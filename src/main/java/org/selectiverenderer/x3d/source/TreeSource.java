package org.selectiverenderer.x3d.source;

import java.util.Arrays;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;

/**
 * A text of another encoding than XML that elements were made of. Where their attributes stand is
 * kept in a row of numbers, sorted when the first place is asked for: who finds nothing wrong asks
 * for none.
 */
final class TreeSource implements ElementSource {
  private static final int NUMBERS = 4;

  private final TextSource text;
  private final SourceText characters;
  private final ValueCleaner cleaner;
  private int[] places = new int[256];
  private int count;
  private long[] order = {};

  TreeSource(TextSource text, SourceText characters, ValueCleaner cleaner) {
    this.text = text;
    this.characters = characters;
    this.cleaner = cleaner;
  }

  /**
   * Notes the next attribute of an element.
   *
   * @param element where it starts
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

  /** Copies characters and blanks what is no part of the value. */
  void copy(int from, int to, char[] into) {
    for (int i = from; i < to; i++) {
      into[i - from] = characters.charAt(i);
    }
    cleaner.clean(into, to - from);
  }

  /** A value's characters, what is no part of it as blanks. */
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
  public Location attribute(int element, int index) {
    int at = find(element, index);
    return location(at < 0 ? element : places[at + 1]);
  }

  @Override
  public Location inAttribute(int element, int index, int character) {
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
  public Location location(int offset) {
    return text.location(offset);
  }

  @Override
  public FieldParser parser() {
    return text.parser();
  }
}
