package org.selectiverenderer.cli.bundle;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;

/** A program that shows the text of its standard input in a window until the user closes it. */
public final class DesktopMessage {
  private static final int COLUMNS = 70;
  private static final int ROWS = 8;

  private DesktopMessage() {}

  public static void main(String[] args) throws IOException {
    String text = new String(System.in.readAllBytes(), StandardCharsets.UTF_8);
    if (!GraphicsEnvironment.isHeadless()) {
      SwingUtilities.invokeLater(() -> show(text));
    }
  }

  /** Shows the text in a text area, so that the user can copy it. */
  private static void show(String text) {
    JTextArea area = new JTextArea(text, ROWS, COLUMNS);
    area.setEditable(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setCaretPosition(0);
    JOptionPane.showMessageDialog(
        null, new JScrollPane(area), "Selective Renderer", JOptionPane.ERROR_MESSAGE);
    System.exit(0);
  }
}
