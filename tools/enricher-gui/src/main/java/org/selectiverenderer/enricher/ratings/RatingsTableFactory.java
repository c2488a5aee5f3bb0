package org.selectiverenderer.enricher.ratings;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.DefaultCellEditor;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.event.TableModelEvent;
import javax.swing.table.TableCellRenderer;
import javax.swing.table.TableColumn;
import javax.swing.table.TableModel;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.component.ColumnHeads;
import org.selectiverenderer.enricher.component.ShortcutTable;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/** Creates the tables of the import dialog, with their captions. */
final class RatingsTableFactory {
  private RatingsTableFactory() {}

  static JTable matches(MatchTableModel model, List<String> switches) {
    JTable table = table(model, Texts.of("ratings.matches"), 26);
    JComboBox<String> box = PlainText.entries(new JComboBox<>());
    box.addItem(MatchTableModel.none());
    switches.forEach(box::addItem);
    box.getAccessibleContext().setAccessibleName(Texts.of("ratings.switchof"));
    DefaultCellEditor editor = new DefaultCellEditor(box);
    editor.setClickCountToStart(1);
    table.getColumnModel().getColumn(MatchTableModel.SWITCH).setCellEditor(editor);
    ColumnHeads.fit(table);
    return table;
  }

  static JTable implied(ImpliedMetadataTableModel model) {
    JTable table = table(model, Texts.of("ratings.implied"), 26);
    int[] shares = {18, 16, 7, 9, 19, 31};
    for (int i = 0; i < shares.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(10 * shares[i]);
    }
    ColumnHeads.fit(table);
    return table;
  }

  static JTable gaze(GazeTableModel model) {
    JTable table = table(model, Texts.of("ratings.gaze"), 36);
    int[] shares = {8, 18, 16, 8, 7, 11, 25, 17};
    for (int i = 0; i < shares.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(10 * shares[i]);
    }
    ColumnHeads.fit(table);
    TableCellRenderer boxes = table.getDefaultRenderer(Boolean.class);
    table.setDefaultRenderer(
        Boolean.class,
        (of, value, selected, focused, row, column) -> {
          Component box =
              boxes.getTableCellRendererComponent(of, value, selected, focused, row, column);
          box.setEnabled(model.isCellEditable(row, column));
          return box;
        });
    return table;
  }

  /**
   * Columns take the width of new rows, up to that of a sentence, of which there are few; a text
   * that is cut off all the same has a tooltip.
   */
  @SuppressWarnings("serial") // never written
  private static final class CompleteTable extends ShortcutTable {
    private static final long serialVersionUID = 1L;

    private static final int MOST_ROWS = 500;

    private static final int PADDING = 3; // the gap between columns, and wider letters

    private final int letters;

    CompleteTable(TableModel model, int letters) {
      super(model);
      this.letters = letters;
      PlainText.cells(this);
    }

    @Override
    public void tableChanged(TableModelEvent event) {
      super.tableChanged(event);
      boolean all = event.getLastRow() == Integer.MAX_VALUE; // Else a column would lose its drag.
      if (all && getColumnCount() == getModel().getColumnCount()) {
        int most = letters * getFontMetrics(getFont()).charWidth('n');
        for (int column = 0; column < getColumnCount(); column++) {
          TableColumn of = getColumnModel().getColumn(column);
          int width = getRowCount() == 0 ? of.getPreferredWidth() : of.getMinWidth();
          for (int row = 0; row < Math.min(getRowCount(), MOST_ROWS); row++) {
            width = Math.max(width, Math.min(most, needed(row, column)));
          }
          of.setPreferredWidth(width);
        }
      }
    }

    private int needed(int row, int column) {
      return prepareRenderer(getCellRenderer(row, column), row, column).getPreferredSize().width
          + PADDING;
    }

    @Override
    public @Nullable String getToolTipText(MouseEvent event) {
      int row = rowAtPoint(event.getPoint());
      int column = columnAtPoint(event.getPoint());
      return row >= 0
              && column >= 0
              && getValueAt(row, column) instanceof String text
              && needed(row, column) > getColumnModel().getColumn(column).getWidth()
          ? PlainText.of(text)
          : super.getToolTipText(event);
    }
  }

  private static JTable table(TableModel model, String name, int letters) {
    JTable table = new CompleteTable(model, letters);
    table.setFillsViewportHeight(true);
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setRowHeight(Math.round(table.getFontMetrics(table.getFont()).getHeight() * 1.4f));
    table.putClientProperty("terminateEditOnFocusLost", true);
    table.getTableHeader().setReorderingAllowed(false);
    table.getAccessibleContext().setAccessibleName(name);
    return table;
  }

  /** Creates a panel with a table under its caption. */
  static JPanel captioned(JLabel label, JTable table, int widthInLetters, int rows) {
    JPanel panel = new JPanel(new MigLayout("insets 0, fill", "[grow,fill]", "[][grow,fill]"));

    label.setLabelFor(table);
    int letter = table.getFontMetrics(table.getFont()).charWidth('n');
    table.setPreferredScrollableViewportSize(
        new Dimension(letter * widthInLetters, table.getRowHeight() * rows));
    panel.add(label, "wrap");
    panel.add(new JScrollPane(table), "grow");
    return panel;
  }
}
