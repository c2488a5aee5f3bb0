package org.selectiverenderer.experiment.window;

import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;

/** Words that go on in the next line where there is no more room. */
final class WrappedText {
  private WrappedText() {}

  /**
   * Words in lines of a width.
   *
   * @param size of the letters in points
   * @param width in pixels
   */
  static JTextArea of(String words, float size, int width) {
    JTextArea text = new ScreenText.Area(words);
    text.setFont(text.getFont().deriveFont(size));
    text.setEditable(false);
    text.setFocusable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setOpaque(false);
    text.setBorder(BorderFactory.createEmptyBorder());
    text.setSize(width, Short.MAX_VALUE); // Its height is known for a width only.
    Dimension needed = new Dimension(width, text.getPreferredSize().height);
    text.setPreferredSize(needed);
    text.setMaximumSize(needed);
    return text;
  }
}
