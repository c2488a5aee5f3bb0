package org.selectiverenderer.scriptengine;

import static org.selectiverenderer.scriptengine.ScriptMeter.allocateCharacters;
import static org.selectiverenderer.scriptengine.ScriptMeter.allocateReferences;
import static org.selectiverenderer.scriptengine.ScriptMeter.bulk;
import static org.selectiverenderer.scriptengine.ScriptMeter.work;

import java.text.Collator;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Methods of the JDK's objects with their work metered. The build lets Rhino call these instead of
 * the methods of the same name; the first parameter is the object. The work of most is in
 * proportion to the length of a text, and is counted before it is done; a search is done here.
 */
public final class MeteredMethods {
  /** A search for a text no longer than this is the JDK's: its work is about that of one pass. */
  private static final int SHORT = 8;

  private MeteredMethods() {}

  public static boolean equals(String text, @Nullable Object other) {
    bulk(text.length());
    return text.equals(other);
  }

  public static boolean equals(Object one, @Nullable Object other) {
    if (one instanceof String text) {
      bulk(text.length());
    }
    return one.equals(other);
  }

  public static int compareTo(String text, String other) {
    bulk(text.length());
    return text.compareTo(other);
  }

  public static boolean contains(String text, CharSequence sought) {
    return indexOf(text, sought.toString(), 0) >= 0;
  }

  public static int indexOf(String text, String sought) {
    return indexOf(text, sought, 0);
  }

  public static int indexOf(String text, String sought, int from) {
    bulk(text.length());
    if (sought.length() <= SHORT) {
      return text.indexOf(sought, from);
    }
    int last = text.length() - sought.length();
    for (int at = Math.max(0, from); at <= last; at++) {
      at = text.indexOf(sought.charAt(0), at);
      if (at < 0 || at > last) {
        return -1;
      }
      if (matches(text, at, sought)) {
        return at;
      }
    }
    return -1;
  }

  public static int lastIndexOf(String text, String sought, int from) {
    bulk(text.length());
    if (sought.length() <= SHORT) {
      return text.lastIndexOf(sought, from);
    }
    for (int at = Math.min(from, text.length() - sought.length()); at >= 0; at--) {
      at = text.lastIndexOf(sought.charAt(0), at);
      if (at < 0) {
        return -1;
      }
      if (matches(text, at, sought)) {
        return at;
      }
    }
    return -1;
  }

  private static boolean matches(String text, int at, String sought) {
    int same = 1;
    while (same < sought.length() && text.charAt(at + same) == sought.charAt(same)) {
      same++;
      if ((same & 0xfff) == 0) {
        work(0x400);
      }
    }
    work(1 + ((same & 0xfff) >> 2));
    return same == sought.length();
  }

  public static int indexOf(String text, int character) {
    bulk(text.length());
    return text.indexOf(character);
  }

  public static int indexOf(String text, int character, int from) {
    bulk(text.length() - from);
    return text.indexOf(character, from);
  }

  public static int lastIndexOf(String text, int character) {
    bulk(text.length());
    return text.lastIndexOf(character);
  }

  public static boolean startsWith(String text, String start) {
    bulk(start.length());
    return text.startsWith(start);
  }

  public static boolean startsWith(String text, String start, int at) {
    bulk(start.length());
    return text.startsWith(start, at);
  }

  public static boolean endsWith(String text, String end) {
    bulk(end.length());
    return text.endsWith(end);
  }

  public static boolean regionMatches(String text, int at, String other, int from, int length) {
    bulk(length);
    return text.regionMatches(at, other, from, length);
  }

  public static boolean regionMatches(
      String text, boolean anyCase, int at, String other, int from, int length) {
    work(Math.max(1, length));
    return text.regionMatches(anyCase, at, other, from, length);
  }

  public static int offsetByCodePoints(String text, int at, int count) {
    work(Math.abs((long) count) >> 2);
    return text.offsetByCodePoints(at, count);
  }

  public static String concat(String text, String more) {
    allocateCharacters(text.length() + more.length());
    return text.concat(more);
  }

  public static String substring(String text, int from) {
    allocateCharacters(text.length() - from);
    return text.substring(from);
  }

  public static String substring(String text, int from, int to) {
    allocateCharacters(to - from);
    return text.substring(from, to);
  }

  public static char[] toCharArray(String text) {
    allocateCharacters(text.length());
    return text.toCharArray();
  }

  public static void getChars(String text, int from, int to, char[] into, int at) {
    bulk(to - from);
    text.getChars(from, to, into, at);
  }

  public static String toLowerCase(String text, Locale locale) {
    return TextParts.change(text, part -> part.toLowerCase(locale));
  }

  public static String toUpperCase(String text, Locale locale) {
    return TextParts.change(text, part -> part.toUpperCase(locale));
  }

  public static String trim(String text) {
    work(text.length() >> 2);
    allocateCharacters(text.length());
    return text.trim();
  }

  public static String intern(String text) {
    bulk(text.length());
    return text.intern();
  }

  public static String replace(String text, CharSequence sought, CharSequence by) {
    work((long) text.length() * sought.length() >> 4);
    return text.replace(sought, by);
  }

  public static String toString(CharSequence text) {
    allocateCharacters(text.length());
    return text.toString();
  }

  public static String toString(StringBuilder text) {
    allocateCharacters(text.length());
    return text.toString();
  }

  public static StringBuilder append(StringBuilder builder, @Nullable String text) {
    if (text != null) {
      grow(builder, text.length());
    }
    return builder.append(text);
  }

  public static StringBuilder append(StringBuilder builder, @Nullable CharSequence text) {
    if (text != null) {
      grow(builder, text.length());
    }
    return builder.append(text);
  }

  public static StringBuilder append(
      StringBuilder builder, @Nullable CharSequence text, int from, int to) {
    grow(builder, to - from);
    work(to - from >> 2);
    return builder.append(text, from, to);
  }

  public static StringBuilder append(StringBuilder builder, char[] text) {
    grow(builder, text.length);
    return builder.append(text);
  }

  public static StringBuilder append(StringBuilder builder, char[] text, int from, int length) {
    grow(builder, length);
    return builder.append(text, from, length);
  }

  public static StringBuilder append(StringBuilder builder, char character) {
    grow(builder, 1);
    return builder.append(character);
  }

  public static StringBuilder insert(StringBuilder builder, int at, String text) {
    bulk(builder.length());
    grow(builder, text.length());
    return builder.insert(at, text);
  }

  public static void ensureCapacity(StringBuilder builder, int capacity) {
    if (capacity > builder.capacity()) {
      allocateCharacters(capacity);
    }
    builder.ensureCapacity(capacity);
  }

  public static void setLength(StringBuilder builder, int length) {
    if (length > builder.length()) {
      grow(builder, length - builder.length());
    }
    builder.setLength(length);
  }

  /** A builder without room for more is copied into one of twice the length. */
  private static void grow(StringBuilder builder, int more) {
    long length = (long) builder.length() + more;
    if (length > builder.capacity()) {
      allocateCharacters(
          (int) Math.min(Integer.MAX_VALUE, Math.max(length, 2L * builder.capacity())));
    } else {
      bulk(more);
    }
  }

  public static boolean add(ArrayList<Object> list, @Nullable Object element) {
    int size = list.size();
    if (size > 512 && (size & 0xff) == 0) {
      work(32); // It is copied after each growth by half.
    }
    return list.add(element);
  }

  public static Object[] toArray(ArrayList<?> list) {
    allocateReferences(list.size());
    return list.toArray();
  }

  public static Object[] toArray(List<?> list) {
    allocateReferences(list.size());
    return list.toArray();
  }

  /**
   * Compares the beginnings as the language does and what follows by character: the JDK's work
   * grows with the square of the number of combining marks.
   */
  public static int compare(Collator collator, String text, String other) {
    if (text.equals(other)) {
      bulk(text.length());
      return 0;
    }
    String beginning = collated(text);
    String otherBeginning = collated(other);
    TextParts.work(Math.max(beginning.length(), otherBeginning.length()));
    int order = collator.compare(beginning, otherBeginning);
    boolean whole = beginning.equals(text) && otherBeginning.equals(other);
    return order == 0 && !whole ? compareTo(text, other) : order;
  }

  private static String collated(String text) {
    return text.length() > TextParts.LENGTH ? text.substring(0, TextParts.LENGTH) : text;
  }
}
