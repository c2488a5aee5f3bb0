package org.selectiverenderer.enricher.problems;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The number of problems of each severity, and of objects and areas that are not enriched yet.
 *
 * @param checking whether the checks of the present text have not ended
 * @param unenriched number of objects and areas without metadata, which is no problem
 * @param enrichable number of all objects and areas
 */
public record ProblemCounts(
    boolean checking, int errors, int warnings, int remarks, int unenriched, int enrichable) {
  static ProblemCounts of(
      boolean checking, List<ProblemEntry> entries, int unenriched, int enrichable) {
    int[] counts = new int[Severity.values().length];
    entries.forEach(entry -> counts[entry.severity().ordinal()]++);
    return new ProblemCounts(
        checking,
        counts[Severity.ERROR.ordinal()],
        counts[Severity.WARNING.ordinal()],
        counts[Severity.INFO.ordinal()],
        unenriched,
        enrichable);
  }

  /** The number of problems of a severity. */
  public int of(Severity severity) {
    return switch (severity) {
      case ERROR -> errors;
      case WARNING -> warnings;
      case INFO -> remarks;
    };
  }

  /** The worst severity among the problems; empty for none. */
  public Optional<Severity> worst() {
    return List.of(Severity.values()).stream().filter(severity -> of(severity) > 0).findFirst();
  }

  /**
   * The counts as the status bar shows them: {@code 2 errors, 1 remark}, or {@code No problems}
   * once that is known.
   */
  public String words() {
    List<String> words = new ArrayList<>();
    for (Severity severity : Severity.values()) {
      if (of(severity) > 0) {
        words.add(words(severity));
      }
    }
    String none = checking ? "problems.checking" : "counts.none";
    return words.isEmpty() ? Texts.of(none) : String.join(", ", words);
  }

  /** The count of a severity as a filter button shows it. */
  String words(Severity severity) {
    int count = of(severity);
    String shown = DecimalFormatter.grouped(count);
    return switch (severity) {
      case ERROR -> Texts.of("counts.errors", count, shown);
      case WARNING -> Texts.of("counts.warnings", count, shown);
      case INFO -> Texts.of("counts.remarks", count, shown);
    };
  }

  /** How many objects and areas are not enriched yet; empty for none. */
  Optional<String> left() {
    return unenriched == 0
        ? Optional.empty()
        : Optional.of(
            Texts.of(
                "counts.unenriched",
                DecimalFormatter.grouped(unenriched),
                DecimalFormatter.grouped(enrichable)));
  }
}
