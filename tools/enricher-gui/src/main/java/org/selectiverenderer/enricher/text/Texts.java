package org.selectiverenderer.enricher.text;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;

/**
 * What the window says, in the language of {@link Locale.Category#DISPLAY}: English where there is
 * no bundle of that language. A text is named by its bundle and its key, {@code area.add} in {@code
 * area.properties}, and is a {@link MessageFormat}: an apostrophe in it is doubled.
 */
public final class Texts {
  private static final ResourceBundle.Control WITHOUT_DEFAULT =
      ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES);

  private Texts() {}

  /**
   * A text with its arguments put in.
   *
   * @param name bundle, dot, key
   * @param arguments strings go in as they are; a number only chooses among plurals, and is shown
   *     by a string made for that
   * @throws java.util.MissingResourceException if no bundle has it
   */
  public static String of(String name, Object... arguments) {
    int dot = name.indexOf('.');
    Locale locale = Locale.getDefault(Locale.Category.DISPLAY);
    ResourceBundle bundle =
        ResourceBundle.getBundle(
            Texts.class.getPackageName() + "." + name.substring(0, dot), locale, WITHOUT_DEFAULT);
    return new MessageFormat(bundle.getString(name.substring(dot + 1)), locale).format(arguments);
  }
}
