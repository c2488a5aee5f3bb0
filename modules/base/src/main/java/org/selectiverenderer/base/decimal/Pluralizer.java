package org.selectiverenderer.base.decimal;

/** Formats a count with its noun in the singular or plural: "1 polygon", "2 polygons". */
public final class Pluralizer {
  private Pluralizer() {}

  /**
   * Returns a number with its noun.
   *
   * @param noun in the singular, with a regular plural in -s
   */
  public static String of(long count, String noun) {
    return count + " " + noun + (count == 1 ? "" : "s");
  }
}
