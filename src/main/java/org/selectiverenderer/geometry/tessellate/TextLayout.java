package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * How a FontStyle node lays out text (X3D 4.0, 15.4.1).
 *
 * @param size of an em
 * @param spacing of lines, in ems
 * @param major alignment of each line by itself along the direction of writing
 * @param minor alignment of all lines together across it
 */
record TextLayout(
    double size,
    double spacing,
    boolean horizontal,
    boolean leftToRight,
    boolean topToBottom,
    Justify major,
    Justify minor) {

  /** The values of {@code justify}. */
  enum Justify {
    FIRST,
    BEGIN,
    MIDDLE,
    END
  }

  static final TextLayout DEFAULT =
      new TextLayout(1, 1, true, true, true, Justify.BEGIN, Justify.FIRST);

  static TextLayout of(TessellationJob job, NodeView fontStyle) {
    String[] justify = fontStyle.strings("justify");
    return new TextLayout(
        positive(job, fontStyle, "size"),
        positive(job, fontStyle, "spacing"),
        fontStyle.bool("horizontal"),
        fontStyle.bool("leftToRight"),
        fontStyle.bool("topToBottom"),
        justify(job, justify, 0, Justify.BEGIN),
        justify(job, justify, 1, Justify.FIRST));
  }

  private static double positive(TessellationJob job, NodeView fontStyle, String field) {
    float value = fontStyle.number(field);
    if (value > 0 && value < Float.POSITIVE_INFINITY || value == 0 && field.equals("spacing")) {
      return value;
    }
    job.problem("has a FontStyle whose " + field + " is not above 0; 1 is used");
    return 1;
  }

  private static Justify justify(
      TessellationJob job, String[] values, int place, Justify otherwise) {
    String value = place < values.length ? values[place] : "";
    if (value.isEmpty()) {
      return otherwise;
    }
    for (Justify justify : Justify.values()) {
      if (justify.name().equals(value)) {
        return justify;
      }
    }
    job.problem("has a FontStyle with justify \"" + value + "\"; " + otherwise + " is used");
    return otherwise;
  }

  /**
   * Where the range that a line or block covers goes, measured in the direction of its advance.
   *
   * @param length of the range
   * @return where its beginning goes
   */
  static double begin(Justify justify, double length) {
    return switch (justify) {
      case FIRST, BEGIN -> 0;
      case MIDDLE -> -length / 2;
      case END -> -length;
    };
  }
}
