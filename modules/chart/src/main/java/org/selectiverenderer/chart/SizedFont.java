package org.selectiverenderer.chart;

import org.selectiverenderer.geometry.font.FontFace;
import org.selectiverenderer.geometry.font.Glyph;

/**
 * A font with a size.
 *
 * @param size pixels per em
 */
public record SizedFont(FontFace font, double size, boolean bold) {
  /** Returns the width of a text in pixels. */
  public double width(String text) {
    return size * text.codePoints().mapToObj(font::glyph).mapToDouble(Glyph::advance).sum();
  }

  /** Returns the text, truncated with an ellipsis if it is wider than that many pixels. */
  public String fit(String text, double width) {
    if (width(text) <= width) {
      return text;
    }
    int end = text.length();
    while (end > 0 && width(text.substring(0, end) + "…") > width) {
      end = text.offsetByCodePoints(end, -1);
    }
    return text.substring(0, end) + "…";
  }
}
