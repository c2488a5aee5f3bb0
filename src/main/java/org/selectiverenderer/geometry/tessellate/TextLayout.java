package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * How a FontStyle (X3D 4.0, 15.4.1) or ScreenFontStyle (36.4.4) lays out text. A ScreenFontStyle's
 * units are pixels: whoever draws it sees to that.
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

  private static final String ON_SCREEN = "ScreenFontStyle";

  /** Pixels of a point, which is a 72nd of an inch, at the 96 pixels per inch of CSS. */
  private static final double PIXELS_PER_POINT = 96.0 / 72;

  /** Whether a node is one of the two. */
  static boolean known(NodeView fontStyle) {
    String name = fontStyle.type().name();
    return name.equals("FontStyle") || name.equals(ON_SCREEN);
  }

  private static double em(TessellationJob job, NodeView fontStyle) {
    return fontStyle.type().name().equals(ON_SCREEN)
        ? PIXELS_PER_POINT * positive(job, fontStyle, "pointSize")
        : positive(job, fontStyle, "size");
  }

  static TextLayout of(TessellationJob job, NodeView fontStyle) {
    String[] justify = fontStyle.strings("justify");
    return new TextLayout(
        em(job, fontStyle),
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
    job.problem(
        "has a %s whose %s is not above 0; 1 is used".formatted(fontStyle.type().name(), field));
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
