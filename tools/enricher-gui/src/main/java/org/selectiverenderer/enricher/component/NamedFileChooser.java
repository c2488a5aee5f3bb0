package org.selectiverenderer.enricher.component;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * A file chooser that stays open, and says why, when somebody types what the system does not accept
 * as the name of a file, such as {@code a|b.x3d} on Windows.
 */
public class NamedFileChooser extends JFileChooser {
  private static final long serialVersionUID = 1L;

  /** Returns the chosen file, after the chooser was closed by its button for that. */
  public final Path chosen() {
    return getSelectedFile().toPath();
  }

  @Override
  public final void approveSelection() {
    File file = getSelectedFile();
    try {
      if (file != null) {
        file.toPath();
      }
    } catch (InvalidPathException e) {
      tell(Texts.of("window.badname", file.getName(), e.getReason()));
      return;
    }
    super.approveSelection();
  }

  /** Shows a sentence over the chooser. */
  protected void tell(String sentence) {
    JOptionPane.showMessageDialog(
        this, PlainText.of(sentence), getDialogTitle(), JOptionPane.WARNING_MESSAGE);
  }
}
