package org.selectiverenderer.enricher.problems;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import javax.swing.table.AbstractTableModel;
import org.selectiverenderer.document.Finding;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problem.Severity;

/** The problems as a table asks for them: those severities that the author wants to see. */
final class ProblemsTableModel extends AbstractTableModel {
  static final int SEVERITY = 0;
  static final int MESSAGE = 1;
  static final int PLACE = 2;
  static final int FIX = 3;
  private static final long serialVersionUID = 1L;
  private static final List<String> COLUMNS = List.of("Severity", "Problem", "Place", "Fix");

  private final transient SceneDocument document;
  private final Set<Severity> wanted = EnumSet.allOf(Severity.class);
  private transient List<Entry> all = List.of();
  private transient List<Entry> shown = List.of();

  ProblemsTableModel(SceneDocument document) {
    this.document = document;
  }

  void entries(List<Entry> entries) {
    all = entries;
    filter();
  }

  void show(Severity severity, boolean visible) {
    if (visible) {
      wanted.add(severity);
    } else {
      wanted.remove(severity);
    }
    filter();
  }

  private void filter() {
    shown = all.stream().filter(entry -> wanted.contains(entry.severity())).toList();
    fireTableDataChanged();
  }

  Entry entry(int row) {
    return shown.get(row);
  }

  @Override
  public int getRowCount() {
    return shown.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.size();
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    Entry entry = shown.get(row);
    return switch (column) {
      case SEVERITY -> entry.severity();
      case MESSAGE -> entry.message();
      case PLACE -> entry.current() ? place(entry) : "";
      default -> entry.fix().map(Finding.Fix::name).orElse("");
    };
  }

  private String place(Entry entry) {
    Location at = entry.location(document);
    if (entry.place() instanceof Entry.Place.Elsewhere) {
      return at.toString();
    }
    String line = at.line() + ":" + at.column();
    return entry.element().map(element -> element + "  " + line).orElse(line);
  }
}
