package org.selectiverenderer.base.decimal;

/** Numbers of things in messages: one polygon, two polygons. */
public final class Counted {
  private Counted() {}

  /**
   * A number with its noun.
   *
   * @param noun in the singular, one that takes an s
   */
  public static String of(long count, String noun) {
    return count + " " + noun + (count == 1 ? "" : "s");
  }
}
