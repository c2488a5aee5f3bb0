package org.selectiverenderer.enricher.run;

import java.awt.Dimension;
import java.awt.Window;
import javax.swing.JDialog;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.text.BadLocationException;
import org.selectiverenderer.enricher.text.Texts;

/** A console window with the output of runs, which opens with the first line. */
public final class RunConsole {
  /** Most characters that are kept; the oldest lines are dropped. */
  private static final int MOST = 200_000;

  private final JTextArea lines = new JTextArea();
  private final JDialog dialog;

  public RunConsole(Window owner) {
    dialog = new JDialog(owner, Texts.of("run.messages"));
    lines.setEditable(false);
    lines.getAccessibleContext().setAccessibleName(Texts.of("run.messages"));
    dialog.setName("run.messages");
    dialog.setFocusableWindowState(false); // The main window keeps the focus.
    dialog.setContentPane(new JScrollPane(lines));
    dialog.setPreferredSize(new Dimension(640, 220));
  }

  /** Appends a line and shows the window. */
  public void add(String line) {
    lines.append(line + "\n");
    try {
      if (lines.getDocument().getLength() > MOST) {
        lines.replaceRange("", 0, lines.getLineEndOffset(lines.getLineOfOffset(MOST / 2)));
      }
    } catch (BadLocationException e) {
      throw new IllegalStateException(e); // the offsets come from the text itself
    }
    lines.setCaretPosition(lines.getDocument().getLength());
    show();
  }

  /** Shows the window. */
  public void show() {
    if (!dialog.isDisplayable()) {
      dialog.pack(); // not earlier: packing realizes the owner before it has its size
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
