package org.selectiverenderer.app.studies.window;

import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import org.selectiverenderer.enricher.text.BundleTexts;

/** Looks up the texts of the study window, as {@link BundleTexts} does. */
final class StudyTexts {
  private static final BundleTexts TEXTS =
      new BundleTexts(StudyTexts.class.getPackageName() + ".studies");

  private StudyTexts() {}

  /** Returns a text with its arguments inserted. */
  static String of(String key, Object... arguments) {
    return TEXTS.of(key, arguments);
  }

  /** Returns a text if the bundle has one, else another. */
  static String orElse(String key, String other) {
    return TEXTS.orElse(key, other);
  }

  /** Creates a button, whose name is the key. */
  static JButton button(String key) {
    return TEXTS.on(new JButton(), key);
  }

  /** Creates a check box, whose name is the key. */
  static JCheckBox checkBox(String key) {
    return TEXTS.on(new JCheckBox(), key);
  }

  /** Creates a label, with its mnemonic if the text has one. */
  static JLabel label(String key, Object... arguments) {
    return TEXTS.label(key, arguments);
  }
}
