package org.selectiverenderer.app.window;

import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;

/** Makes text areas that wrap their text at a fixed width. */
final class WrappedTextArea {
  private WrappedTextArea() {}

  /**
   * Returns a text area with wrapped text.
   *
   * @param size font size in points
   * @param width in pixels
   */
  static JTextArea of(String words, float size, int width) {
    JTextArea text = new HiDpiComponents.Area(words);
    text.setFont(text.getFont().deriveFont(size));
    text.setEditable(false);
    text.setFocusable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setOpaque(false);
    text.setBorder(BorderFactory.createEmptyBorder());
    text.setSize(width, Short.MAX_VALUE); // The height depends on the width.
    Dimension needed = new Dimension(width, text.getPreferredSize().height);
    text.setPreferredSize(needed);
    text.setMaximumSize(needed);
    return text;
  }
}
