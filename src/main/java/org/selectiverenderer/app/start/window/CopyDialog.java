package org.selectiverenderer.app.start.window;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/** Asks into which folder the examples are copied. */
final class CopyDialog {
  private static final int COLUMNS = 44;

  private final JDialog dialog;
  private final JTextField folder = new JTextField(COLUMNS);
  private @Nullable Path chosen;

  private CopyDialog(JFrame owner, Path proposed, int files, long bytes) {
    dialog = new JDialog(owner, StartTexts.of("copy.title"), true);
    dialog.setName("copy");
    dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    JPanel content =
        new JPanel(new MigLayout("insets 16, fillx, wrap 3", "[][grow,fill][]", "[]12[]16[]"));
    content.add(
        StartTexts.paragraph(
            StartTexts.of(
                "copy.about",
                Integer.toString(files),
                String.format(Locale.ROOT, "%.0f", bytes / 1e6))),
        "span 3, growx, wmin 200, width 480");
    JLabel label = StartTexts.label("copy.folder");
    label.setLabelFor(folder);
    folder.setName("copy.folder");
    folder.setText(proposed.toString());
    JButton choose = StartTexts.button("copy.choose");
    choose.addActionListener(event -> choose());
    JButton copy = StartTexts.button("copy.do");
    copy.addActionListener(event -> accept());
    JButton cancel = StartTexts.button("copy.cancel");
    cancel.addActionListener(event -> dialog.dispose());
    content.add(label);
    content.add(folder);
    content.add(choose);
    content.add(copy, "span 3, split 2, right, tag ok");
    content.add(cancel, "tag cancel");
    dialog.setContentPane(content);
    dialog
        .getRootPane()
        .registerKeyboardAction(
            event -> dialog.dispose(),
            KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.pack();
    dialog.pack(); // The text has wrapped, so that its height is known.
    dialog.getRootPane().setDefaultButton(copy);
    dialog.setLocationRelativeTo(owner);
  }

  /**
   * Asks the user.
   *
   * @param proposed the folder that is proposed
   * @return empty if the user does not want them
   */
  static Optional<Path> ask(JFrame owner, Path proposed, int files, long bytes) {
    CopyDialog asked = new CopyDialog(owner, proposed, files, bytes);
    asked.dialog.setVisible(true);
    return Optional.ofNullable(asked.chosen);
  }

  private void choose() {
    JFileChooser chooser = new JFileChooser(existing(new File(folder.getText())));
    chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
    if (chooser.showDialog(dialog, StartTexts.of("copy.chooser")) == JFileChooser.APPROVE_OPTION) {
      folder.setText(chooser.getSelectedFile().toString());
    }
  }

  private static @Nullable File existing(File place) {
    File found = place;
    while (found != null && !found.isDirectory()) {
      found = found.getParentFile();
    }
    return found;
  }

  private void accept() {
    try {
      Path typed = Path.of(folder.getText().strip());
      if (typed.isAbsolute()) {
        chosen = typed;
        dialog.dispose();
        return;
      }
    } catch (InvalidPathException e) {
      // As with a relative one: the field keeps the focus.
    }
    folder.selectAll();
    folder.requestFocusInWindow();
  }
}
