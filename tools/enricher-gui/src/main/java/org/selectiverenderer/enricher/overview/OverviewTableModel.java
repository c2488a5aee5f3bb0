package org.selectiverenderer.enricher.overview;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.table.AbstractTableModel;
import org.selectiverenderer.base.decimal.DecimalText;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.ElementFinding;
import org.selectiverenderer.document.enrichment.EnrichedSwitch;
import org.selectiverenderer.document.enrichment.Enrichment;
import org.selectiverenderer.document.enrichment.SchemaOverview;
import org.selectiverenderer.document.enrichment.SchemaOverview.Cell;
import org.selectiverenderer.document.enrichment.SchemaOverview.Place;
import org.selectiverenderer.document.enrichment.SchemaSpelling;
import org.selectiverenderer.document.enrichment.VersionLadder;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.Degree;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Objects by schemas as a table: column 0 has the objects' names, the others a schema each, their
 * cells the degree. Cells are read when they are painted.
 */
@SuppressWarnings("serial") // never written
final class OverviewTableModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  private final Enrichment enrichment;
  private final Consumer<Supplier<Edit>> make;
  private final List<String> added = new ArrayList<>();
  private List<String> columns = List.of();
  private final OverviewRows rows;
  private SchemaOverview overview;
  private Map<String, ElementFinding> marks = Map.of();
  private RowFilter filter = RowFilter.NONE;
  private RowOrder order = RowOrder.DOCUMENT;

  /**
   * @param make makes an edit and does it, and says so where that is refused
   */
  OverviewTableModel(Enrichment enrichment, Consumer<Supplier<Edit>> make) {
    this.enrichment = enrichment;
    this.make = make;
    this.rows = new OverviewRows(enrichment, this::degree);
    this.overview = new SchemaOverview(enrichment, added);
    this.marks = enrichment.schemaFindings();
    this.columns = overview.schemas();
    arrange();
  }

  /** Reads the document again after a change. */
  void refresh() {
    List<String> before = columns;
    int objectsBefore = overview.objects().size();
    overview = new SchemaOverview(enrichment, added);
    columns = stable(before, overview.schemas());
    marks = enrichment.schemaFindings();
    boolean sameRows = overview.objects().size() == objectsBefore && rows.stay();
    if (!sameRows) {
      arrange();
    }
    if (!before.equals(columns)) {
      fireTableStructureChanged();
    } else if (!sameRows) {
      fireTableDataChanged();
    } else if (rows.count() > 0) {
      fireTableRowsUpdated(0, rows.count() - 1);
    }
  }

  /** Schemas that are there still keep their places, others come behind. */
  private static List<String> stable(List<String> before, List<String> now) {
    Set<String> stable = new LinkedHashSet<>(before);
    stable.retainAll(new HashSet<>(now));
    stable.addAll(now);
    return List.copyOf(stable);
  }

  private void arrange() {
    rows.arrange(overview.objects(), columns, filter, order);
  }

  void filter(RowFilter wanted) {
    filter = wanted;
    arrange();
    fireTableDataChanged();
  }

  RowOrder order() {
    return order;
  }

  void sort(RowOrder wanted) {
    order = wanted;
    arrange();
    fireTableDataChanged();
  }

  /** How many objects there are, shown or not. */
  int objectCount() {
    return overview.objects().size();
  }

  EnrichedSwitch node(int row) {
    return rows.node(row);
  }

  /** The row of an object or of what stands in it; -1 if it is not shown. */
  int row(DocumentElement element) {
    return rows.row(element);
  }

  /** The schema of a column from 1 on. */
  String schema(int column) {
    return columns.get(column - 1);
  }

  List<String> schemas() {
    return columns;
  }

  /** What is wrong with the schema of a column. */
  Optional<ElementFinding> mark(int column) {
    return column == 0 ? Optional.empty() : Optional.ofNullable(marks.get(schema(column)));
  }

  /** All that is wrong with schemas. */
  List<ElementFinding> marks() {
    return List.copyOf(marks.values());
  }

  /**
   * Gives a schema a column although nothing names it yet.
   *
   * @throws EditRefused if there is such a column, or no name
   */
  void addSchema(String name) {
    String schema = name.strip();
    if (schema.isEmpty()) {
      throw new EditRefused(Texts.of("overview.noname"));
    }
    SchemaSpelling.complaint(schema)
        .ifPresent(
            why -> {
              throw new EditRefused(why);
            });
    if (columns.contains(schema)) {
      throw new EditRefused(Texts.of("overview.twice", schema));
    }
    added.add(schema);
    refresh();
  }

  /** A schema has got another name; a column that nothing names is renamed, too. */
  void renamed(String from, String to) {
    if (added.remove(from) && !to.isBlank()) {
      added.add(to.strip());
    }
    refresh();
  }

  /** A schema is not named any more and needs no column. */
  void removed(String schema) {
    added.remove(schema);
    refresh();
  }

  /** Fills cells with a degree, or empties them, as one step; column 0 is left alone. */
  void fill(Collection<CellAt> cells, Optional<Degree> degree) {
    List<Place> filled =
        cells.stream().filter(c -> c.column() > 0).map(this::place).distinct().toList();
    if (!filled.isEmpty()) {
      make.accept(
          () -> degree.map(d -> overview.fill(filled, d)).orElseGet(() -> overview.clear(filled)));
    }
  }

  /** Fills cells with a degree each, as one step. */
  void put(Map<CellAt, CellInput> cells) {
    Map<Place, Optional<Degree>> wanted = new LinkedHashMap<>();
    cells.forEach((at, input) -> wanted.put(place(at), input.degree()));
    make.accept(
        () ->
            overview.edit(
                Texts.of("overview.paste.step", wanted.size(), DecimalText.grouped(wanted.size())),
                wanted));
  }

  private Place place(CellAt cell) {
    return new Place(rows.node(cell.row()), schema(cell.column()));
  }

  /** The degree that a cell stands for, given or by its version's place; empty for none. */
  private Optional<Degree> degree(EnrichedSwitch node, String schema) {
    return overview.cell(node, schema).map(cell -> degree(node, cell));
  }

  private static Degree degree(EnrichedSwitch node, Cell cell) {
    return cell.degree().orElse(VersionLadder.degree(cell.choice(), node.choices().size()));
  }

  /** What a cell stands for. */
  ConsistencySign sign(int row, int column) {
    return ConsistencySign.of(overview.cell(rows.node(row), schema(column)));
  }

  /** What a cell's tooltip says. */
  String explanation(int row, int column) {
    EnrichedSwitch node = rows.node(row);
    if (column == 0) {
      return Texts.of(
          "overview.versions",
          node.name(),
          node.choices().size(),
          DecimalText.grouped(node.choices().size()));
    }
    String schema = schema(column);
    return overview
        .cell(node, schema)
        .map(
            cell ->
                Texts.of(
                    "overview.shows",
                    node.object(),
                    schema,
                    DecimalText.grouped(cell.choice() + 1),
                    DecimalText.grouped(node.choices().size()),
                    cell.type().map(type -> ", " + type.spelling()).orElse("")))
        .orElse(Texts.of("overview.outside", node.object(), schema));
  }

  @Override
  public int getRowCount() {
    return rows.count();
  }

  @Override
  public int getColumnCount() {
    return 1 + columns.size();
  }

  @Override
  public String getColumnName(int column) {
    return column == 0 ? Texts.of("overview.object") : schema(column);
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return String.class;
  }

  /** The degree as in the metadata; in parentheses where only the version says it. */
  @Override
  public Object getValueAt(int row, int column) {
    EnrichedSwitch node = rows.node(row);
    if (column == 0) {
      return node.object();
    }
    return overview
        .cell(node, schema(column))
        .map(
            cell ->
                cell.degree().isPresent()
                    ? cell.degree().get().spelling()
                    : "(" + degree(node, cell).spelling() + ")")
        .orElse("");
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column > 0;
  }

  /** Takes what the author wrote; what is no degree changes nothing. */
  @Override
  public void setValueAt(Object value, int row, int column) {
    if (!getValueAt(row, column).equals(value)) {
      CellInput.of(String.valueOf(value))
          .ifPresent(input -> fill(List.of(new CellAt(row, column)), input.degree()));
    }
  }
}
