package org.selectiverenderer.app.studies.window;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.swing.PlainText;

/**
 * Looks up the texts of the study window in the language of {@link Locale.Category#DISPLAY};
 * English where there is no bundle of that language. A text is a {@link MessageFormat}; {@code &}
 * stands before the mnemonic of a button or label.
 */
final class StudyTexts {
  private static final ResourceBundle.Control WITHOUT_DEFAULT =
      ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);

  private StudyTexts() {}

  /**
   * Returns a text with its arguments inserted.
   *
   * @param arguments strings are inserted as they are, and never begin HTML; a number only selects
   *     a plural form, and is shown by a separate string argument
   */
  static String of(String key, Object... arguments) {
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    return PlainText.of(new MessageFormat(bundle(locale).getString(key), locale).format(arguments));
  }

  /** Returns a text if the bundle has one, else another. */
  static String orElse(String key, String other) {
    ResourceBundle bundle = bundle(Locale.getDefault(Locale.Category.DISPLAY));
    return PlainText.of(bundle.containsKey(key) ? bundle.getString(key) : other);
  }

  private static ResourceBundle bundle(Locale locale) {
    return ResourceBundle.getBundle(
        StudyTexts.class.getPackageName() + ".studies", locale, WITHOUT_DEFAULT);
  }

  /** Creates a button, whose name is the key. */
  static JButton button(String key) {
    return on(new JButton(), key);
  }

  /** Creates a check box, whose name is the key. */
  static JCheckBox checkBox(String key) {
    return on(new JCheckBox(), key);
  }

  private static <B extends AbstractButton> B on(B button, String key) {
    button.setName(key);
    return Mnemonics.on(button, of(key));
  }

  /** Creates a label, with its mnemonic if the text has one. */
  static JLabel label(String key, Object... arguments) {
    return Mnemonics.on(new JLabel(), of(key, arguments));
  }
}
