package org.selectiverenderer.schema;

import java.util.Collection;
import java.util.Optional;
import org.selectiverenderer.base.problem.SpellingSuggester;

/** Detects misspelt schema names, which otherwise have no effect and cause no error. */
public final class SchemaNameMatcher {
  private static final int SLIPS = 2;
  private static final int SHORT = 4;

  private SchemaNameMatcher() {}

  /**
   * Returns the name that the author probably meant, one that differs in letter case or in at most
   * two letters. Names that differ in a number (Room1, Room2) and very short names that differ in a
   * letter are taken to be intended.
   */
  public static Optional<String> probablyMeant(String schema, Collection<String> others) {
    return SpellingSuggester.nearest(
        schema,
        others.stream()
            .filter(other -> !other.equals(schema))
            .filter(other -> !sameButForDigits(schema, other))
            .toList(),
        schema.length() < SHORT ? 0 : SLIPS);
  }

  /** Compares two names without their digits, without allocation for thousands of names. */
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
