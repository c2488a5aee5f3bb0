package org.selectiverenderer.app.studies.window;

import java.awt.Font;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.process.ProgramCommand;

/** A button, and beside it the command line that does the same, to be copied. */
final class ActionLine extends JPanel {
  private static final long serialVersionUID = 1;

  private final JButton action;
  private final JTextField line = new JTextField();
  private final JButton copy = StudyTexts.button("copy");

  /**
   * @param key of the button's text
   * @param does what the button does
   */
  ActionLine(String key, Runnable does) {
    super(new MigLayout("insets 0, fillx", "[][grow,fill][]"));
    action = StudyTexts.button(key);
    action.addActionListener(event -> does.run());
    line.setName(key + ".command");
    line.setEditable(false);
    line.setFont(new Font(Font.MONOSPACED, Font.PLAIN, line.getFont().getSize()));
    line.getAccessibleContext().setAccessibleName(StudyTexts.of("command"));
    line.setToolTipText(StudyTexts.of("command.tip"));
    copy.setName(key + ".copy");
    copy.getAccessibleContext().setAccessibleDescription(StudyTexts.of("command.tip"));
    copy.addActionListener(
        event ->
            Toolkit.getDefaultToolkit()
                .getSystemClipboard()
                .setContents(new StringSelection(line.getText()), null));
    add(action);
    add(line, "wmin 60");
    add(copy);
  }

  /** Shows a command; without one the button is disabled. */
  void command(Optional<ProgramCommand> command) {
    String text =
        command.map(known -> known.line().orElse(StudyTexts.of("command.none"))).orElse("");
    if (!text.equals(line.getText())) {
      line.setText(text);
      line.setCaretPosition(0);
    }
    action.setEnabled(command.isPresent());
    copy.setEnabled(command.flatMap(ProgramCommand::line).isPresent());
  }

  /** Disables the button while its command runs, or where it cannot be run now. */
  void allow(boolean on) {
    action.setEnabled(on);
  }

  JButton button() {
    return action;
  }
}
