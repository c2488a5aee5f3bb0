package org.selectiverenderer.x3d.tessellate;

import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * The text layout defined by a FontStyle (X3D 4.0, 15.4.1) or ScreenFontStyle (36.4.4). The units
 * of a ScreenFontStyle are pixels, to which the renderer must scale them.
 *
 * @param size the size of an em
 * @param spacing the line spacing, in ems
 * @param major alignment of each line along the direction of writing
 * @param minor alignment of the block of lines across the direction of writing
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

  /** Pixels per point, a 72nd of an inch, at the 96 pixels per inch of CSS. */
  private static final double PIXELS_PER_POINT = 96.0 / 72;

  /** Returns whether a node is a FontStyle or ScreenFontStyle. */
  static boolean known(NodeView fontStyle) {
    String name = fontStyle.type().name();
    return name.equals("FontStyle") || name.equals(ON_SCREEN);
  }

  private static double em(TessellationContext job, NodeView fontStyle) {
    return fontStyle.type().name().equals(ON_SCREEN)
        ? PIXELS_PER_POINT * positive(job, fontStyle, "pointSize")
        : positive(job, fontStyle, "size");
  }

  static TextLayout of(TessellationContext job, NodeView fontStyle) {
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

  private static double positive(TessellationContext job, NodeView fontStyle, String field) {
    float value = fontStyle.number(field);
    if (value > 0 && value < Float.POSITIVE_INFINITY || value == 0 && field.equals("spacing")) {
      return value;
    }
    job.problem(
        "has a %s whose %s is not above 0; 1 is used".formatted(fontStyle.type().name(), field));
    return 1;
  }

  private static Justify justify(
      TessellationContext job, String[] values, int place, Justify otherwise) {
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
   * Returns the start position of a line or block, along the direction of its advance.
   *
   * @param length the length of the line or block
   */
  static double begin(Justify justify, double length) {
    return switch (justify) {
      case FIRST, BEGIN -> 0;
      case MIDDLE -> -length / 2;
      case END -> -length;
    };
  }
}
