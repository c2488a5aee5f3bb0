package org.selectiverenderer.geometry.font;

/** The font families that every X3D browser supports (X3D 4.0, 15.2.2.2). */
public enum FontFamily {
  /** A serif font. */
  SERIF("Serif", "Italic"),
  /** A sans-serif font. */
  SANS("Sans", "Oblique"),
  /** A monospaced font. */
  TYPEWRITER("SansMono", "Oblique");

  private final String fileName;
  private final String slanted;

  FontFamily(String fileName, String slanted) {
    this.fileName = fileName;
    this.slanted = slanted;
  }

  /** Returns the family of the first known name, case-sensitive; SERIF if none is known. */
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

  /** Returns the resource name of the font file for a style. */
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
