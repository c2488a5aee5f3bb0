package org.selectiverenderer.enricher.problems;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;

/** The table model of the problems whose severities are shown. */
final class ProblemsTableModel extends RowTableModel<ProblemEntry> {
  static final int SEVERITY = 0;
  static final int MESSAGE = 1;
  static final int PLACE = 2;
  static final int FIX = 3;
  private static final long serialVersionUID = 1L;

  private final transient SceneDocument document;
  private final Set<Severity> wanted = EnumSet.allOf(Severity.class);
  private transient List<ProblemEntry> all = List.of();

  ProblemsTableModel(SceneDocument document) {
    super(
        Texts.of("problems.severity"),
        Texts.of("problems.problem"),
        Texts.of("problems.place"),
        Texts.of("problems.fixes"));
    this.document = document;
  }

  void entries(List<ProblemEntry> entries) {
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
    show(all.stream().filter(entry -> wanted.contains(entry.severity())).toList());
  }

  @Override
  protected Object cell(ProblemEntry entry, int column) {
    return switch (column) {
      case SEVERITY -> entry.severity();
      case MESSAGE -> entry.message();
      case PLACE -> entry.current() ? place(entry) : "";
      default -> entry.fix().map(ElementFinding.Fix::name).orElse("");
    };
  }

  private String place(ProblemEntry entry) {
    SourceLocation at = entry.location(document);
    if (entry.place() instanceof ProblemEntry.Place.Elsewhere) {
      return at.toString();
    }
    String line = at.line() + ":" + at.column();
    return entry.element().map(element -> element + "  " + line).orElse(line);
  }
}
