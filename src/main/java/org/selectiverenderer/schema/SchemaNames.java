package org.selectiverenderer.schema;

import java.util.Collection;
import java.util.Optional;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.Spelling;

/** Compares names of schemas, in which slips show only by their having no effect. */
public final class SchemaNames {
  private static final Pattern DIGITS = Pattern.compile("[0-9]+");
  private static final int SLIPS = 2;
  private static final int SHORT = 4;

  private SchemaNames() {}

  /**
   * The name that the author probably meant: one that differs by letter case or by one or two
   * letters. Names that differ by a number (Room1, Room2) or by a letter of a very short name are
   * different on purpose.
   */
  public static Optional<String> probablyMeant(String schema, Collection<String> others) {
    String letters = DIGITS.matcher(schema).replaceAll("");
    return Spelling.nearest(
        schema,
        others.stream()
            .filter(other -> !other.equals(schema))
            .filter(other -> !DIGITS.matcher(other).replaceAll("").equals(letters))
            .toList(),
        schema.length() < SHORT ? 0 : SLIPS);
  }
}
