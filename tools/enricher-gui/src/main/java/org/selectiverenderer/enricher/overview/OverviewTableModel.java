package org.selectiverenderer.enricher.overview;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.table.AbstractTableModel;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Cell;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Place;
import org.selectiverenderer.authoring.enrichment.SchemaNameValidator;
import org.selectiverenderer.authoring.enrichment.VersionDegreeMapping;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The table model of objects by schemas: column 0 has the objects' names, each other column a
 * schema, whose cells hold the degree. Cells are computed when they are painted.
 */
@SuppressWarnings("serial") // never written
final class OverviewTableModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  private final DocumentEnrichment enrichment;
  private final Consumer<Supplier<Edit>> make;
  private final List<String> added = new ArrayList<>();
  private List<String> columns = List.of();
  private final OverviewRows rows;
  private ObjectSchemaMatrix overview;
  private Map<String, ElementFinding> marks = Map.of();
  private ObjectRowFilter filter = ObjectRowFilter.NONE;
  private RowSortKey order = RowSortKey.DOCUMENT;

  /**
   * @param make creates and performs an edit, and tells the author if it is refused
   */
  OverviewTableModel(DocumentEnrichment enrichment, Consumer<Supplier<Edit>> make) {
    this.enrichment = enrichment;
    this.make = make;
    this.rows = new OverviewRows(enrichment, this::degree);
    this.overview = new ObjectSchemaMatrix(enrichment, added);
    this.marks = enrichment.schemaFindings();
    this.columns = overview.schemas();
    arrange();
  }

  /** Reads the document again after a change. */
  void refresh() {
    List<String> before = columns;
    int objectsBefore = overview.objects().size();
    overview = new ObjectSchemaMatrix(enrichment, added);
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

  /** Returns the new schemas; those known before keep their order, others follow. */
  private static List<String> stable(List<String> before, List<String> now) {
    Set<String> stable = new LinkedHashSet<>(before);
    stable.retainAll(new HashSet<>(now));
    stable.addAll(now);
    return List.copyOf(stable);
  }

  private void arrange() {
    rows.arrange(overview.objects(), columns, filter, order);
  }

  void filter(ObjectRowFilter wanted) {
    filter = wanted;
    arrange();
    fireTableDataChanged();
  }

  RowSortKey order() {
    return order;
  }

  void sort(RowSortKey wanted) {
    order = wanted;
    arrange();
    fireTableDataChanged();
  }

  /** The number of objects, shown or not. */
  int objectCount() {
    return overview.objects().size();
  }

  EnrichedSwitch node(int row) {
    return rows.node(row);
  }

  /** The row of an object or of the object around an element; -1 if it is not shown. */
  int row(DocumentElement element) {
    return rows.row(element);
  }

  /** The schema of a column, from 1. */
  String schema(int column) {
    return columns.get(column - 1);
  }

  List<String> schemas() {
    return columns;
  }

  /** The finding about the schema of a column; empty for none. */
  Optional<ElementFinding> mark(int column) {
    return column == 0 ? Optional.empty() : Optional.ofNullable(marks.get(schema(column)));
  }

  /** All findings about schemas. */
  List<ElementFinding> marks() {
    return List.copyOf(marks.values());
  }

  /**
   * Adds a column for a schema that nothing in the scene names yet.
   *
   * @throws EditRejectedException if there is such a column, or the name is invalid
   */
  void addSchema(String name) {
    String schema = name.strip();
    if (schema.isEmpty()) {
      throw new EditRejectedException(Texts.of("overview.noname"));
    }
    SchemaNameValidator.complaint(schema)
        .ifPresent(
            why -> {
              throw new EditRejectedException(why);
            });
    if (columns.contains(schema)) {
      throw new EditRejectedException(Texts.of("overview.twice", schema));
    }
    added.add(schema);
    refresh();
  }

  /** Follows the renaming of a schema, also of a column that nothing in the scene names. */
  void renamed(String from, String to) {
    if (added.remove(from) && !to.isBlank()) {
      added.add(to.strip());
    }
    refresh();
  }

  /** Follows the removal of a schema, whose column goes. */
  void removed(String schema) {
    added.remove(schema);
    refresh();
  }

  /** Sets cells to a degree, or clears them, as one undo step; ignores column 0. */
  void fill(Collection<CellPosition> cells, Optional<ConsistencyDegree> degree) {
    List<Place> filled =
        cells.stream().filter(c -> c.column() > 0).map(this::place).distinct().toList();
    if (!filled.isEmpty()) {
      make.accept(
          () -> degree.map(d -> overview.fill(filled, d)).orElseGet(() -> overview.clear(filled)));
    }
  }

  /** Sets each cell to its own degree, as one undo step. */
  void put(Map<CellPosition, CellInput> cells) {
    Map<Place, Optional<ConsistencyDegree>> wanted = new LinkedHashMap<>();
    cells.forEach((at, input) -> wanted.put(place(at), input.degree()));
    make.accept(
        () ->
            overview.edit(
                Texts.of(
                    "overview.paste.step", wanted.size(), DecimalFormatter.grouped(wanted.size())),
                wanted));
  }

  private Place place(CellPosition cell) {
    return new Place(rows.node(cell.row()), schema(cell.column()));
  }

  /**
   * The degree of a cell: as given in the metadata, else by the version's position; empty for none.
   */
  private Optional<ConsistencyDegree> degree(EnrichedSwitch node, String schema) {
    return overview.cell(node, schema).map(cell -> degree(node, cell));
  }

  private static ConsistencyDegree degree(EnrichedSwitch node, Cell cell) {
    return cell.degree().orElse(VersionDegreeMapping.degree(cell.choice(), node.choices().size()));
  }

  /** The symbol of a cell. */
  ConsistencySymbol sign(int row, int column) {
    return ConsistencySymbol.of(overview.cell(rows.node(row), schema(column)));
  }

  /** The longest usual text of a cell about qualities beside versions; empty for no such object. */
  String longestOthers() {
    return overview.objects().stream()
        .map(
            node ->
                node.qualities().stream()
                    .map(quality -> quality.quality().spelling() + " high")
                    .distinct()
                    .collect(Collectors.joining(", ")))
        .max(Comparator.comparingInt(String::length))
        .orElse("");
  }

  /**
   * What a cell says beside the degree of the versions: of column 0 the names of the object's other
   * qualities, else their degrees; empty for none.
   */
  String others(int row, int column) {
    EnrichedSwitch node = rows.node(row);
    if (column == 0) {
      return node.qualities().stream()
          .map(quality -> quality.quality().spelling())
          .distinct()
          .collect(Collectors.joining(", "));
    }
    return overview.levels(node, schema(column)).entrySet().stream()
        .map(level -> level.getKey().spelling() + " " + level.getValue().spelling())
        .collect(Collectors.joining(", "));
  }

  /** The tooltip of a cell. */
  String explanation(int row, int column) {
    String others = others(row, column);
    String own = explanationOfVersions(row, column);
    return others.isEmpty() ? own : own + Texts.of("overview.others", others);
  }

  private String explanationOfVersions(int row, int column) {
    EnrichedSwitch node = rows.node(row);
    if (column == 0) {
      return Texts.of(
          "overview.versions",
          node.name(),
          node.choices().size(),
          DecimalFormatter.grouped(node.choices().size()));
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
                    DecimalFormatter.grouped(cell.choice() + 1),
                    DecimalFormatter.grouped(node.choices().size()),
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

  /**
   * Returns the degree as in the metadata; in parentheses where it only follows from the version's
   * position.
   */
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

  /** Sets the degree that the author wrote; an invalid text changes nothing. */
  @Override
  public void setValueAt(Object value, int row, int column) {
    if (!getValueAt(row, column).equals(value)) {
      CellInput.of(String.valueOf(value))
          .ifPresent(input -> fill(List.of(new CellPosition(row, column)), input.degree()));
    }
  }
}
