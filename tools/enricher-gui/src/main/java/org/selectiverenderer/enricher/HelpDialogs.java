package org.selectiverenderer.enricher;

import java.awt.Dimension;
import java.util.List;
import java.util.Optional;
import javax.swing.ImageIcon;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.DefaultTableModel;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.text.Texts;

/** The dialogs of the Help menu: the list of keyboard shortcuts, and the About dialog. */
final class HelpDialogs {
  private static final int ICON = 64;

  private final JFrame frame;

  HelpDialogs(JFrame frame) {
    this.frame = frame;
  }

  /** Shows all keyboard shortcuts of the window in its present state. */
  void keys() {
    JTable table = new JTable(keyTable());
    table.getAccessibleContext().setAccessibleName(Texts.of("about.keys"));
    table.setFillsViewportHeight(true);
    JScrollPane scroll = new JScrollPane(table);
    int line = table.getRowHeight();
    scroll.setPreferredSize(new Dimension(line * 32, line * 22));
    show(scroll, Texts.of("about.keys"), JOptionPane.PLAIN_MESSAGE, null);
  }

  DefaultTableModel keyTable() {
    List<KeyBindingList.Entry> entries =
        KeyBindingList.of(frame.getJMenuBar(), frame.getContentPane());
    Object[][] rows =
        entries.stream()
            .map(entry -> new Object[] {entry.part(), entry.key(), entry.does()})
            .toArray(Object[][]::new);
    Object[] heads = {Texts.of("about.part"), Texts.of("about.key"), Texts.of("about.does")};
    return new DefaultTableModel(rows, heads) {
      private static final long serialVersionUID = 1L;

      @Override
      public boolean isCellEditable(int row, int column) {
        return false;
      }
    };
  }

  /**
   * Shows the About dialog.
   *
   * @param drawnBy the OpenGL renderer of the preview; empty while it is not known
   */
  void about(Optional<String> drawnBy) {
    JTextArea text = new JTextArea(aboutText(drawnBy));
    text.setEditable(false);
    text.setOpaque(false);
    text.getAccessibleContext().setAccessibleName(Texts.of("about.title"));
    show(
        text,
        Texts.of("about.title"),
        JOptionPane.INFORMATION_MESSAGE,
        new ImageIcon(WindowIcon.image(ICON)));
  }

  /** Returns version, Java, system and OpenGL renderer, as a bug report needs them. */
  static String aboutText(Optional<String> drawnBy) {
    String version =
        Optional.ofNullable(HelpDialogs.class.getPackage().getImplementationVersion())
            .orElseGet(() -> Texts.of("about.development"));
    return String.join(
        "\n",
        Texts.of("about.version", version),
        Texts.of("about.licence"),
        Texts.of("about.thesis"),
        "",
        Texts.of(
            "about.java", System.getProperty("java.version"), System.getProperty("java.vendor")),
        Texts.of("about.system", System.getProperty("os.name"), System.getProperty("os.version")),
        Texts.of("about.gl", drawnBy.orElseGet(() -> Texts.of("about.nogl"))));
  }

  private void show(JComponent content, String title, int kind, @Nullable ImageIcon icon) {
    JOptionPane.showMessageDialog(frame, content, title, kind, icon);
  }
}
