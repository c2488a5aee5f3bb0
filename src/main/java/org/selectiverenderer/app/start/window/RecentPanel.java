package org.selectiverenderer.app.start.window;

import java.awt.BorderLayout;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import org.selectiverenderer.app.start.RecentFile;
import org.selectiverenderer.swing.PlainText;

/** The files that were opened lately. */
final class RecentPanel extends JPanel {
  private static final long serialVersionUID = 1;
  private static final int ROWS = 5;

  private final DefaultListModel<Row> files = new DefaultListModel<>();
  private final JList<Row> list = PlainText.entries(new JList<>(files));
  private final JLabel none = new JLabel(StartTexts.of("recent.none"));
  private final JScrollPane scroll = new JScrollPane(list);
  private final JButton again = StartTexts.button("recent.open");
  private final transient Consumer<RecentFile> open;

  /** A line of the list. */
  private record Row(RecentFile file) {
    @Override
    public String toString() {
      Path path = file.file();
      String kind = StartTexts.of("recent." + file.kind().name().toLowerCase(Locale.ROOT));
      return "%s \u2013 %s   (%s)".formatted(kind, path.getFileName(), path.getParent());
    }
  }

  RecentPanel(Consumer<RecentFile> open) {
    super(new BorderLayout(8, 4));
    this.open = open;
    list.setName("recent");
    list.getAccessibleContext().setAccessibleName(StartTexts.of("recent"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setVisibleRowCount(ROWS);
    list.addListSelectionListener(event -> select());
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              open();
            }
          }
        });
    list.registerKeyboardAction(
        event -> open(), KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), WHEN_FOCUSED);
    again.addActionListener(event -> open());
    JPanel side = new JPanel(new BorderLayout());
    side.add(again, BorderLayout.NORTH);
    add(none, BorderLayout.NORTH);
    add(scroll, BorderLayout.CENTER);
    add(side, BorderLayout.EAST);
    show(List.of());
  }

  /** Shows files; what was selected stays so. */
  void show(List<RecentFile> known) {
    List<Row> rows = known.stream().map(Row::new).toList();
    boolean some = !rows.isEmpty();
    none.setVisible(!some);
    scroll.setVisible(some);
    again.setVisible(some);
    if (rows.equals(Collections.list(files.elements()))) {
      return;
    }
    Row selected = list.getSelectedValue();
    files.clear();
    files.addAll(rows);
    if (some) {
      list.setSelectedIndex(Math.max(0, rows.indexOf(selected)));
    }
    select();
  }

  private void select() {
    again.setEnabled(list.getSelectedValue() != null);
  }

  private void open() {
    Row row = list.getSelectedValue();
    if (row != null) {
      open.accept(row.file());
    }
  }
}
