package org.selectiverenderer.enricher.overview;

import java.awt.Component;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.LookAndFeel;
import javax.swing.UIManager;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableCellRenderer;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * Renders a column header: its name, the sort direction, and a warning sign where there is a
 * finding about its schema.
 */
final class SchemaHeaderRenderer implements TableCellRenderer {
  private final OverviewTableModel model;
  private LookAndFeel theme = UIManager.getLookAndFeel();
  private TableCellRenderer plain = plain();

  SchemaHeaderRenderer(OverviewTableModel model) {
    this.model = model;
  }

  private static TableCellRenderer plain() {
    TableCellRenderer made = new JTableHeader().getDefaultRenderer();
    if (made instanceof JComponent component) {
      PlainText.only(component);
    }
    return made;
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int viewColumn) {
    if (UIManager.getLookAndFeel() != theme) {
      theme = UIManager.getLookAndFeel(); // Swing updates default renderers only
      plain = plain();
    }
    Component component =
        plain.getTableCellRendererComponent(table, value, selected, focused, row, viewColumn);
    int column = table.convertColumnIndexToModel(viewColumn);
    Optional<ElementFinding> mark =
        column < model.getColumnCount() ? model.mark(column) : Optional.empty();
    RowSortKey order = model.order();
    String arrow = order.column() != column ? "" : order.descending() ? " \u2193" : " \u2191";
    if (component instanceof JLabel label) {
      label.setText((mark.isPresent() ? "\u26a0 " : "") + value + arrow);
    }
    if (component instanceof JComponent head) {
      head.setToolTipText(
          mark.map(finding -> PlainText.of(finding.message()))
              .orElseGet(
                  () ->
                      Texts.of(
                          column == 0 ? "terms.sort" : "terms.sortschema",
                          model.getColumnName(column))));
    }
    return component;
  }
}
