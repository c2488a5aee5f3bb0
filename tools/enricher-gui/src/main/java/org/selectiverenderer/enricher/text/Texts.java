package org.selectiverenderer.enricher.text;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import org.selectiverenderer.swing.PlainText;

/**
 * Looks up the texts of the window in the language of {@link Locale.Category#DISPLAY}; English
 * where there is no bundle of that language. A text is named by its bundle and its key, {@code
 * area.add} for {@code add} in {@code area.properties}, and is a {@link MessageFormat}: an
 * apostrophe in it is doubled.
 */
public final class Texts {
  private static final ResourceBundle.Control WITHOUT_DEFAULT =
      ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);

  private Texts() {}

  /**
   * Returns a text with its arguments inserted.
   *
   * @param name name of the bundle, a dot, and the key
   * @param arguments strings are inserted as they are, and never begin HTML; a number only selects
   *     a plural form, and is shown by a separate string argument
   * @throws java.util.MissingResourceException if the bundle has no such key
   */
  public static String of(String name, Object... arguments) {
    int dot = name.indexOf('.');
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    String text = bundle(name.substring(0, dot), locale).getString(name.substring(dot + 1));
    return PlainText.of(new MessageFormat(text, locale).format(arguments));
  }

  /** The keys of all texts in a bundle. */
  static Set<String> keys(String bundle) {
    return bundle(bundle, Locale.ROOT).keySet();
  }

  private static ResourceBundle bundle(String name, Locale locale) {
    return ResourceBundle.getBundle(
        Texts.class.getPackageName() + "." + name, locale, WITHOUT_DEFAULT);
  }
}
