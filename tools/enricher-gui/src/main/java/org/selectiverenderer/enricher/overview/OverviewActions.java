package org.selectiverenderer.enricher.overview;

import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPopupMenu;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyDegree;

/** The actions on the selected cells, bound to keys and in the context menu. */
final class OverviewActions {
  private final SchemaTable table;
  private final OverviewTableModel model;
  private final CellClipboard cells;
  private final Consumer<String> say;
  private final MetadataClipboard metadata;
  final KeyedAction high;
  final KeyedAction low;
  final KeyedAction clear;
  final KeyedAction sort;

  /**
   * @param metadata copies and pastes the metadata of whole objects
   * @param say shows a message below the table
   */
  OverviewActions(
      SchemaTable table,
      OverviewTableModel model,
      MetadataClipboard metadata,
      Consumer<String> say) {
    this.metadata = metadata;
    this.table = table;
    this.model = model;
    this.cells = new CellClipboard(model);
    this.say = say;
    this.high =
        new KeyedAction(
                Texts.of("overview.high"), "H", () -> fill(Optional.of(ConsistencyDegree.HIGH)))
            .in(table);
    this.low =
        new KeyedAction(
                Texts.of("overview.low"), "L", () -> fill(Optional.of(ConsistencyDegree.LOW)))
            .in(table);
    this.clear =
        new KeyedAction(Texts.of("overview.clear"), "DELETE", () -> fill(Optional.empty()))
            .in(table);
    this.sort = new KeyedAction(Texts.of("overview.sort.schema"), "S", this::sort).in(table);
    new KeyedAction(Texts.of("overview.clear.too"), "BACK_SPACE", () -> fill(Optional.empty()))
        .in(table);
    for (char digit : "0123456789.".toCharArray()) {
      new KeyedAction(
              Texts.of("overview.write", String.valueOf(digit)),
              "typed " + digit,
              () -> table.write(digit))
          .in(table);
    }
    table.setComponentPopupMenu(menu());
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.add(high);
    menu.add(low);
    menu.add(clear);
    menu.addSeparator();
    menu.add(new KeyedAction(Texts.of("overview.cut"), "menu X", this::cut).in(table));
    menu.add(
        new KeyedAction(Texts.of("overview.copy.cells"), "menu C", () -> copy(false)).in(table));
    menu.add(
        new KeyedAction(Texts.of("overview.copy.names"), "menu shift C", () -> copy(true))
            .in(table));
    menu.add(new KeyedAction(Texts.of("overview.paste.cells"), "menu V", this::paste).in(table));
    menu.addSeparator();
    menu.add(
        new KeyedAction(
                Texts.of("overview.copy"),
                "ctrl alt C",
                () -> metadata.copy(table.selectedElements()))
            .in(table));
    menu.add(
        new KeyedAction(
                Texts.of("overview.paste"),
                "ctrl alt V",
                () -> metadata.paste(table.selectedElements()))
            .in(table));
    menu.addSeparator();
    menu.add(
        new KeyedAction(Texts.of("overview.select.column"), "ctrl SPACE", this::selectColumn)
            .in(table));
    menu.addSeparator();
    menu.add(sort);
    menu.add(new KeyedAction(Texts.of("overview.sort.object"), "N", () -> sort(0)).in(table));
    return menu;
  }

  /** Sets the degree of the selected cells, or clears them. */
  void fill(Optional<ConsistencyDegree> degree) {
    List<CellPosition> selected = table.selectedCells();
    if (selected.isEmpty()) {
      say.accept(Texts.of("overview.fill"));
    } else {
      attempt(() -> model.fill(selected, degree));
    }
  }

  private void sort() {
    table.currentSchema().ifPresent(schema -> sort(1 + model.schemas().indexOf(schema)));
  }

  private void sort(int column) {
    table.keepingSelection(() -> model.sort(model.order().clicked(column)));
  }

  /**
   * Selects all shown cells of the selected columns; with a filter, such as a room's objects at
   * once.
   */
  private void selectColumn() {
    if (table.getRowCount() > 0 && table.getSelectedColumnCount() > 0) {
      table.setRowSelectionInterval(0, table.getRowCount() - 1);
    }
  }

  private void cut() {
    copy(false);
    fill(Optional.empty());
  }

  private void copy(boolean withNames) {
    List<CellPosition> selected = table.selectedCells();
    if (!selected.isEmpty()) {
      clipboard().setContents(new StringSelection(cells.copy(selected, withNames)), null);
    }
  }

  private void paste() {
    attempt(
        () -> {
          try {
            Object text = clipboard().getData(DataFlavor.stringFlavor);
            model.put(cells.paste(String.valueOf(text), table.selectedCells()));
          } catch (UnsupportedFlavorException | IOException e) {
            throw new EditRejectedException(Texts.of("overview.noclipboard"));
          }
        });
  }

  private static Clipboard clipboard() {
    return Toolkit.getDefaultToolkit().getSystemClipboard();
  }

  private void attempt(Runnable work) {
    try {
      work.run();
    } catch (EditRejectedException e) {
      say.accept(Remarks.of(e));
    }
  }
}
