package org.selectiverenderer.enricher.run;

import java.awt.Dimension;
import java.awt.Window;
import javax.swing.JDialog;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.text.BadLocationException;
import org.selectiverenderer.enricher.text.Texts;

/** What runs have said, in a window beside the author's, which comes up with the first line. */
public final class RunMessages {
  /** Characters that are kept; the oldest lines go. */
  private static final int MOST = 200_000;

  private final JTextArea lines = new JTextArea();
  private final JDialog dialog;

  public RunMessages(Window owner) {
    dialog = new JDialog(owner, Texts.of("run.messages"));
    lines.setEditable(false);
    lines.getAccessibleContext().setAccessibleName(Texts.of("run.messages"));
    dialog.setName("run.messages");
    dialog.setFocusableWindowState(false); // The author goes on where he is.
    dialog.setContentPane(new JScrollPane(lines));
    dialog.setPreferredSize(new Dimension(640, 220));
  }

  /** Shows a line more. */
  public void add(String line) {
    lines.append(line + "\n");
    try {
      if (lines.getDocument().getLength() > MOST) {
        lines.replaceRange("", 0, lines.getLineEndOffset(lines.getLineOfOffset(MOST / 2)));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException(e); // The places are those of the text itself.
    }
    lines.setCaretPosition(lines.getDocument().getLength());
    show();
  }

  /** Shows what has been said so far. */
  public void show() {
    if (!dialog.isDisplayable()) {
      dialog.pack(); // not before: it makes the owner known to the system, without its size
      dialog.setLocationRelativeTo(dialog.getOwner());
    }
    if (!dialog.isVisible()) {
      dialog.setVisible(true);
    }
  }

  public void dispose() {
    dialog.dispose();
  }
}
