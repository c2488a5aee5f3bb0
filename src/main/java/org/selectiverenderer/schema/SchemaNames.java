package org.selectiverenderer.schema;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.base.problem.Spelling;

/** Compares names of schemas, in which slips show only by their having no effect. */
public final class SchemaNames {
  private static final int SLIPS = 2;
  private static final int SHORT = 4;

  private SchemaNames() {}

  /**
   * The name that the author probably meant: one that differs by letter case or by one or two
   * letters. Names that differ by a number (Room1, Room2) or by a letter of a very short name are
   * different on purpose.
   */
  public static Optional<String> probablyMeant(String schema, Collection<String> others) {
    return Spelling.nearest(
        schema,
        others.stream()
            .filter(other -> !other.equals(schema))
            .filter(other -> !sameButForDigits(schema, other))
            .toList(),
        schema.length() < SHORT ? 0 : SLIPS);
  }

  /** Compares what is left without digits; by hand, as there may be thousands of names. */
  private static boolean sameButForDigits(String one, String other) {
    int i = 0;
    int j = 0;
    while (true) {
      i = behindDigits(one, i);
      j = behindDigits(other, j);
      if (i == one.length() || j == other.length()) {
        return i == one.length() && j == other.length();
      }
      if (one.charAt(i++) != other.charAt(j++)) {
        return false;
      }
    }
  }

  private static int behindDigits(String name, int from) {
    int at = from;
    while (at < name.length() && name.charAt(at) >= '0' && name.charAt(at) <= '9') {
      at++;
    }
    return at;
  }
}
