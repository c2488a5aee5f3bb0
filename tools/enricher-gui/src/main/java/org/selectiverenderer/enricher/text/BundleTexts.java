package org.selectiverenderer.enricher.text;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import org.selectiverenderer.swing.PlainText;

/**
 * Looks up the texts of one bundle in the language of {@link Locale.Category#DISPLAY}, for windows
 * beside the enricher's; English where there is no bundle of that language. A text is a {@link
 * MessageFormat}; {@code &} stands before the mnemonic of a button or label.
 */
public final class BundleTexts {
  private static final ResourceBundle.Control WITHOUT_DEFAULT =
      ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);

  private final String bundle;

  /**
   * @param bundle name of the bundle, with its package
   */
  public BundleTexts(String bundle) {
    this.bundle = bundle;
  }

  /**
   * Returns a text with its arguments inserted.
   *
   * @param arguments strings are inserted as they are, and never begin HTML; a number only selects
   *     a plural form, and is shown by a separate string argument
   * @throws java.util.MissingResourceException if the bundle has no such key
   */
  public String of(String key, Object... arguments) {
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    return PlainText.of(new MessageFormat(in(locale).getString(key), locale).format(arguments));
  }

  /** Returns a text if the bundle has one, else another. */
  public String orElse(String key, String other) {
    ResourceBundle texts = in(Locale.getDefault(Locale.Category.DISPLAY));
    return PlainText.of(texts.containsKey(key) ? texts.getString(key) : other);
  }

  private ResourceBundle in(Locale locale) {
    return ResourceBundle.getBundle(bundle, locale, WITHOUT_DEFAULT);
  }

  /** Gives a button its text, its mnemonic, and its key for a name. */
  public <B extends AbstractButton> B on(B button, String key) {
    button.setName(key);
    return Mnemonics.on(button, of(key));
  }

  /** Creates a label, with its mnemonic if the text has one. */
  public JLabel label(String key, Object... arguments) {
    return Mnemonics.on(new JLabel(), of(key, arguments));
  }
}
