package org.selectiverenderer.geometry.font;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** A font whose glyphs are made when first asked for and then kept. Safe for several threads. */
public final class Font {
  private final TrueTypeFile file;
  private final Map<Integer, Glyph> glyphs = new ConcurrentHashMap<>();

  Font(TrueTypeFile file) {
    this.file = file;
  }

  /** How far glyphs reach above the base line, in ems. */
  public float ascent() {
    return (float) file.ascent() / file.unitsPerEm();
  }

  /** How far glyphs reach below the base line, in ems; positive. */
  public float descent() {
    return (float) -file.descent() / file.unitsPerEm();
  }

  /** The glyph of a character: a box if the font has none, a space for control characters. */
  public Glyph glyph(int codePoint) {
    int shown = Character.isISOControl(codePoint) ? ' ' : codePoint;
    return glyphs.computeIfAbsent(file.glyphOf(shown), this::make);
  }

  private Glyph make(int glyph) {
    float em = file.unitsPerEm();
    List<float[]> contours = Contours.of(file, glyph);
    return OutlineFiller.fill(contours, file.advance(glyph) / em, 1 / em);
  }
}
