package org.selectiverenderer.app.start.window;

import java.awt.Font;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.start.StartCommands;

/** Shows what the command {@code doctor} finds, as it finds it. */
final class DoctorDialog {
  private final JDialog dialog;
  private final JLabel state = new JLabel(StartTexts.of("doctor.running"));
  private final JProgressBar bar = new JProgressBar();
  private final JTextArea text = new JTextArea(20, 100);

  private DoctorDialog(JFrame owner) {
    dialog = new JDialog(owner, StartTexts.of("doctor.title"), false);
    dialog.setName("doctor");
    dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    state.setName("doctor.state");
    bar.setIndeterminate(true);
    text.setName("doctor.text");
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, text.getFont().getSize()));
    text.getAccessibleContext().setAccessibleName(StartTexts.of("doctor.text"));
    JButton copy = StartTexts.button("doctor.copy");
    copy.addActionListener(
        event ->
            Toolkit.getDefaultToolkit()
                .getSystemClipboard()
                .setContents(new StringSelection(text.getText()), null));
    JButton close = StartTexts.button("doctor.close");
    close.addActionListener(event -> dialog.dispose());
    JPanel content =
        new JPanel(
            new MigLayout(
                "insets 12, fill, wrap 2, hidemode 3", "[grow,fill][]", "[][grow,fill][]"));
    content.add(state);
    content.add(bar, "width 120");
    content.add(new JScrollPane(text), "span 2, grow, push");
    content.add(copy, "span 2, split 2, right");
    content.add(close);
    dialog.setContentPane(content);
    dialog
        .getRootPane()
        .registerKeyboardAction(
            event -> dialog.dispose(),
            KeyStroke.getKeyStroke("ESCAPE"),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.pack();
    dialog.setSize(
        Math.min(dialog.getWidth(), owner.getGraphicsConfiguration().getBounds().width),
        dialog.getHeight());
    dialog.setLocationRelativeTo(owner);
    dialog.getRootPane().setDefaultButton(close);
  }

  /** Opens the window and looks at the machine. */
  static void show(JFrame owner, Launcher launcher) {
    DoctorDialog shown = new DoctorDialog(owner);
    shown.dialog.setVisible(true);
    launcher.start(StartCommands.doctor(), shown::add, shown::ended);
  }

  private void add(String line) {
    text.append(line + "\n");
    text.setCaretPosition(0);
  }

  private void ended(int status) {
    bar.setVisible(false);
    state.setText(
        switch (status) {
          case 0 -> StartTexts.of("doctor.well");
          case 1 -> StartTexts.of("doctor.lacks");
          default -> StartTexts.of("doctor.ended", Integer.toString(status));
        });
  }
}
