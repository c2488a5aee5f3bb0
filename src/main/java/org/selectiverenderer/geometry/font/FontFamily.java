package org.selectiverenderer.geometry.font;

/** The font families that every browser has (X3D 4.0, 15.2.2.2). */
public enum FontFamily {
  /** Letters with feet. */
  SERIF("Serif", "Italic"),
  /** Letters without. */
  SANS("Sans", "Oblique"),
  /** Letters of one width. */
  TYPEWRITER("SansMono", "Oblique");

  private final String fileName;
  private final String slanted;

  FontFamily(String fileName, String slanted) {
    this.fileName = fileName;
    this.slanted = slanted;
  }

  /** The first name that is a family's; SERIF if none is. Names are case-sensitive. */
  public static FontFamily of(String... names) {
    for (String name : names) {
      for (FontFamily family : values()) {
        if (family.name().equals(name)) {
          return family;
        }
      }
    }
    return SERIF;
  }

  /** The resource that holds the family's font in a style. */
  String resource(FontStyle style) {
    String suffix =
        switch (style) {
          case PLAIN -> "";
          case BOLD -> "-Bold";
          case ITALIC -> "-" + slanted;
          case BOLDITALIC -> "-Bold" + slanted;
        };
    return "DejaVu" + fileName + suffix + ".ttf";
  }
}
