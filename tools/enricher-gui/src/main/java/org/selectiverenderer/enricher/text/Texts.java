package org.selectiverenderer.enricher.text;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;
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
    ResourceBundle bundle =
        ResourceBundle.getBundle(
            Texts.class.getPackageName() + "." + name.substring(0, dot), locale, WITHOUT_DEFAULT);
    return PlainText.of(
        new MessageFormat(bundle.getString(name.substring(dot + 1)), locale).format(arguments));
  }
}
