package org.selectiverenderer.enricher.component;

import java.io.File;
import javax.swing.JTextField;

/** Selects the name of the file in a field with a path, as dialogs that save files do. */
public final class FileNameSelection {
  private FileNameSelection() {}

  /**
   * Selects the name without its folder and its ending, so that what is typed replaces it alone.
   *
   * @param ending the ending with its dot; a name with another one is selected whole
   */
  public static void select(JTextField path, String ending) {
    String text = path.getText();
    int end = text.endsWith(ending) ? text.length() - ending.length() : text.length();
    path.select(text.lastIndexOf(File.separatorChar) + 1, end);
  }
}
