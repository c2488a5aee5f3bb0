package org.selectiverenderer.app.start.window;

import java.awt.Dimension;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import org.selectiverenderer.enricher.text.BundleTexts;

/** Looks up the texts of the start window, as {@link BundleTexts} does. */
final class StartTexts {
  private static final BundleTexts TEXTS =
      new BundleTexts(StartTexts.class.getPackageName() + ".start");

  private StartTexts() {}

  /** Returns a text with its arguments inserted. */
  static String of(String key, Object... arguments) {
    return TEXTS.of(key, arguments);
  }

  /** Creates a button, whose name is the key. */
  static JButton button(String key) {
    return TEXTS.on(new JButton(), key);
  }

  /** Creates a label, with its mnemonic if the text has one. */
  static JLabel label(String key) {
    return TEXTS.label(key);
  }

  /** Creates a text that wraps where its place ends, looks like a label and takes no focus. */
  static JTextArea paragraph(String text) {
    JTextArea area =
        new JTextArea(text) {
          private static final long serialVersionUID = 1;

          @Override
          public Dimension getMinimumSize() {
            return new Dimension(80, super.getMinimumSize().height);
          }

          @Override
          public void updateUI() {
            super.updateUI();
            setFont(UIManager.getFont("Label.font"));
            setForeground(UIManager.getColor("Label.foreground"));
          }
        };
    area.setEditable(false);
    area.setFocusable(false);
    area.setOpaque(false);
    area.setBorder(null);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    return area;
  }
}
