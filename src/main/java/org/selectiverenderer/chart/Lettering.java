package org.selectiverenderer.chart;

import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontLibrary;
import org.selectiverenderer.geometry.font.FontStyle;

/**
 * The three sizes in which a page of charts is written.
 *
 * @param title of a chart
 * @param label of what is drawn
 * @param small along the axes
 */
record Lettering(SizedFont title, SizedFont label, SizedFont small) {
  /** In pixels per em. */
  static Lettering of(double title, double label, double small) {
    FontLibrary fonts = new FontLibrary();
    return new Lettering(
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.BOLD), title, true),
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), label, false),
        new SizedFont(fonts.font(FontFamily.SANS, FontStyle.PLAIN), small, false));
  }
}
