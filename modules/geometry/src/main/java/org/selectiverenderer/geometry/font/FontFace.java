package org.selectiverenderer.geometry.font;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** A font face that tessellates its glyphs on first use and caches them. Thread-safe. */
public final class FontFace {
  private final TrueTypeFile file;
  private final Map<Integer, Glyph> glyphs = new ConcurrentHashMap<>();

  FontFace(TrueTypeFile file) {
    this.file = file;
  }

  /** Returns the ascent above the baseline, in ems. */
  public float ascent() {
    return (float) file.ascent() / file.unitsPerEm();
  }

  /** Returns the descent below the baseline, in ems; positive. */
  public float descent() {
    return (float) -file.descent() / file.unitsPerEm();
  }

  /** Returns the glyph of a character; a box if it is missing, a space for control characters. */
  public Glyph glyph(int codePoint) {
    int shown = Character.isISOControl(codePoint) ? ' ' : codePoint;
    return glyphs.computeIfAbsent(file.glyphOf(shown), this::make);
  }

  private Glyph make(int glyph) {
    float em = file.unitsPerEm();
    List<float[]> contours = GlyphOutlineReader.of(file, glyph);
    return GlyphTriangulator.fill(contours, file.advance(glyph) / em, 1 / em);
  }
}
