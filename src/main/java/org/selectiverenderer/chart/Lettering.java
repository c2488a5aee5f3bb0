package org.selectiverenderer.chart;

import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;

/**
 * The fonts of a page of charts.
 *
 * @param title font of chart titles
 * @param label font of labels
 * @param small font of the numbers along the axes
 */
record Lettering(SizedFont title, SizedFont label, SizedFont small) {
  /** Creates fonts of these sizes, in pixels per em. */
  static Lettering of(double title, double label, double small) {
    FontLibrary fonts = new FontLibrary();
    return new Lettering(
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), title, true),
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), label, false),
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), small, false));
  }
}
