package org.selectiverenderer.enricher.overview;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.event.TableModelEvent;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.DefaultTableColumnModel;
import javax.swing.table.JTableHeader;
import javax.swing.table.TableColumn;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.component.ShortcutTable;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The table of the overview; the objects' names are in a second table that does not scroll
 * horizontally. Selection is by cells, and a value written into one cell of a selection goes to all
 * of them.
 */
@SuppressWarnings("serial") // never written
final class SchemaTable extends ShortcutTable {
  private static final long serialVersionUID = 1L;

  private final OverviewTableModel model;
  private final JTable names;

  SchemaTable(OverviewTableModel model) {
    super(model);
    this.model = model;
    this.names = new NameTable(model, getSelectionModel());
    setAutoResizeMode(AUTO_RESIZE_OFF);
    setAutoCreateColumnsFromModel(false);
    setCellSelectionEnabled(true);
    setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
    setDefaultEditor(String.class, new DegreeCellEditor());
    setDefaultRenderer(String.class, new ConsistencyCellRenderer(model));
    setSurrendersFocusOnKeystroke(true);
    putClientProperty("terminateEditOnFocusLost", true);
    putClientProperty("JTable.autoStartsEdit", false); // letters are shortcuts here
    setShowGrid(true);
    setColumns();
    PlainText.cells(this);
    PlainText.cells(names);
    dress(this);
    dress(names);
    getAccessibleContext().setAccessibleName(Texts.of("overview.table"));
    getAccessibleContext().setAccessibleDescription(Texts.of("overview.table.keys"));
  }

  /** The row header with the objects' names. */
  @SuppressWarnings("serial") // never written
  private static final class NameTable extends JTable {
    private static final long serialVersionUID = 1L;
    private final OverviewTableModel model;

    NameTable(OverviewTableModel model, ListSelectionModel rows) {
      super(model);
      this.model = model;
      setAutoCreateColumnsFromModel(false);
      while (getColumnCount() > 1) {
        getColumnModel().removeColumn(getColumnModel().getColumn(1));
      }
      setSelectionModel(rows);
      setShowGrid(true);
      setFocusable(false); // keeps the focus in the cells
      getAccessibleContext().setAccessibleName(Texts.of("overview.objects"));
    }

    @Override
    public String getToolTipText(MouseEvent event) {
      int row = rowAtPoint(event.getPoint());
      return row < 0 ? null : PlainText.of(model.explanation(row, 0));
    }
  }

  private static void rowHeight(JTable table) {
    table.setRowHeight(Math.round(table.getFontMetrics(table.getFont()).getHeight() * 1.4f));
  }

  private void dress(JTable table) {
    rowHeight(table);
    table.addPropertyChangeListener("font", event -> rowHeight(table));
    JTableHeader header = table.getTableHeader();
    header.setReorderingAllowed(false);
    header.setDefaultRenderer(new SchemaHeaderRenderer(model));
    header.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            int column = header.columnAtPoint(event.getPoint());
            if (column >= 0 && SwingUtilities.isLeftMouseButton(event)) {
              keepingSelection(
                  () -> model.sort(model.order().clicked(table.convertColumnIndexToModel(column))));
            }
          }
        });
  }

  /** Creates a scroll pane with names and cells. */
  JScrollPane scrolling() {
    JScrollPane pane = new JScrollPane(this);
    pane.setRowHeaderView(names);
    pane.setCorner(JScrollPane.UPPER_LEADING_CORNER, names.getTableHeader());
    names.setPreferredScrollableViewportSize(
        new java.awt.Dimension(names.getFontMetrics(names.getFont()).charWidth('m') * 14, 0));
    return pane;
  }

  private void setColumns() {
    // A new column model, as a table lays itself out after every single column change.
    DefaultTableColumnModel columns = new DefaultTableColumnModel();
    columns.setSelectionModel(getColumnModel().getSelectionModel());
    columns.getSelectionModel().clearSelection();
    columns.setColumnSelectionAllowed(getColumnModel().getColumnSelectionAllowed());
    String others = model.longestOthers();
    String wide = others.isEmpty() ? "" : "mm high \u00b7 " + others + "m";
    for (int i = 1; i < model.getColumnCount(); i++) {
      TableColumn column = new TableColumn(i);
      column.setHeaderValue(model.getColumnName(i));
      int width =
          Math.max(
              getFontMetrics(getFont()).stringWidth(model.getColumnName(i) + "mm"),
              getFontMetrics(getFont()).stringWidth(wide));
      column.setPreferredWidth(Math.max(width, getFontMetrics(getFont()).stringWidth("m") * 7));
      columns.addColumn(column);
    }
    setColumnModel(columns);
  }

  @Override
  public void tableChanged(TableModelEvent event) {
    super.tableChanged(event);
    // The constructor of JTable calls this before the fields here are set.
    if (model != null && event.getFirstRow() == TableModelEvent.HEADER_ROW) {
      setColumns();
    }
  }

  /** Changes the model and selects the same objects and schemas again. */
  void keepingSelection(Runnable change) {
    List<DocumentElement> rows = new ArrayList<>();
    for (int row : getSelectedRows()) {
      rows.add(model.node(row).element());
    }
    List<String> columns = new ArrayList<>();
    for (int column : getSelectedColumns()) {
      columns.add(model.schema(convertColumnIndexToModel(column)));
    }
    if (isEditing()) {
      getCellEditor().cancelCellEditing();
    }
    getSelectionModel().setValueIsAdjusting(true);
    change.run();
    if (getSelectedRowCount() == 0) {
      for (DocumentElement element : rows) {
        int row = model.row(element);
        if (row >= 0) {
          addRowSelectionInterval(row, row);
        }
      }
    }
    if (getSelectedColumnCount() == 0) {
      for (String schema : columns) {
        int column = model.schemas().indexOf(schema);
        if (column >= 0) {
          addColumnSelectionInterval(column, column);
        }
      }
    }
    getSelectionModel().setValueIsAdjusting(false);
    getTableHeader().repaint();
    names.getTableHeader().repaint();
  }

  /** The selected cells, row by row. */
  List<CellPosition> selectedCells() {
    List<CellPosition> cells = new ArrayList<>();
    for (int row : getSelectedRows()) {
      for (int column : getSelectedColumns()) {
        cells.add(new CellPosition(row, convertColumnIndexToModel(column)));
      }
    }
    return cells;
  }

  /** The objects of the selected rows. */
  List<DocumentElement> selectedElements() {
    List<DocumentElement> elements = new ArrayList<>();
    for (int row : getSelectedRows()) {
      elements.add(model.node(row).element());
    }
    return elements;
  }

  /** The schema of the lead selection's column; empty for none. */
  Optional<String> currentSchema() {
    int column = getColumnModel().getSelectionModel().getLeadSelectionIndex();
    return column < 0 || column >= getColumnCount()
        ? Optional.empty()
        : Optional.of(model.schema(convertColumnIndexToModel(column)));
  }

  /** Selects an object's row and scrolls to it. */
  void show(DocumentElement element) {
    int row = model.row(element);
    if (row < 0) {
      clearSelection();
      return;
    }
    if (!isRowSelected(row)) {
      setRowSelectionInterval(row, row);
    }
    if (getSelectedColumnCount() == 0 && getColumnCount() > 0) {
      setColumnSelectionInterval(0, 0);
    }
    scrollRectToVisible(getCellRect(row, Math.max(0, getSelectedColumn()), true));
  }

  /** Starts editing the lead cell with a typed character. */
  void write(char first) {
    int row = getSelectionModel().getLeadSelectionIndex();
    int column = getColumnModel().getSelectionModel().getLeadSelectionIndex();
    if (row >= 0 && column >= 0 && editCellAt(row, column)) {
      ((DegreeCellEditor) getCellEditor()).begin(first);
    }
  }

  /** Sets a value; one written into a selected cell goes to all selected cells. */
  @Override
  public void setValueAt(Object value, int row, int column) {
    List<CellPosition> cells = selectedCells();
    if (cells.size() < 2 || !isCellSelected(row, column)) {
      super.setValueAt(value, row, column);
      return;
    }
    CellInput.of(String.valueOf(value)).ifPresent(input -> model.fill(cells, input.degree()));
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    return row < 0 || column < 0
        ? null
        : PlainText.of(model.explanation(row, convertColumnIndexToModel(column)));
  }

  @Override
  public Component prepareEditor(javax.swing.table.TableCellEditor editor, int row, int column) {
    Component component = super.prepareEditor(editor, row, column);
    component
        .getAccessibleContext()
        .setAccessibleName(
            Texts.of(
                "overview.degree",
                model.node(row).object(),
                model.schema(convertColumnIndexToModel(column))));
    return component;
  }

  /** Renders a degree with the symbol and the tint of the consistency type. */
  private static final class ConsistencyCellRenderer extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    private final OverviewTableModel model;

    ConsistencyCellRenderer(OverviewTableModel model) {
      this.model = model;
      PlainText.only(this);
    }

    @Override
    public Component getTableCellRendererComponent(
        JTable table,
        @Nullable Object value,
        boolean selected,
        boolean focused,
        int row,
        int column) {
      setBackground(null);
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      ConsistencySymbol sign = model.sign(row, table.convertColumnIndexToModel(column));
      setIcon(sign.icon());
      String others = model.others(row, table.convertColumnIndexToModel(column));
      if (!others.isEmpty()) {
        setText(String.valueOf(value).isEmpty() ? others : value + " \u00b7 " + others);
      }
      if (!selected) {
        setBackground(sign.ground(table.getBackground()));
      }
      getAccessibleContext().setAccessibleName((getText() + " " + sign.words()).strip());
      return this;
    }
  }
}
