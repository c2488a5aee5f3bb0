package org.selectiverenderer.enricher.text;

import javax.swing.UIDefaults;
import javax.swing.UIManager;

/**
 * Gives Swing's own dialogs (file chooser, colour chooser, questions) the texts of the window's
 * language: Java has them in five languages, and takes that of the system.
 */
public final class ToolkitTexts {
  private static final String BUNDLE = "toolkit";

  private ToolkitTexts() {}

  /** Has dialogs that are made from now on say what the bundle says in the display's language. */
  public static void install() {
    for (String key : Texts.keys(BUNDLE)) {
      UIDefaults.ActiveValue text = table -> Texts.of(BUNDLE + "." + key);
      UIManager.put(key, text);
    }
  }
}
