package org.selectiverenderer.enricher.problems;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Problem.Severity;

/** How many problems there are of each kind. */
public record ProblemCounts(int errors, int warnings, int remarks) {
  static ProblemCounts of(List<ProblemEntry> entries) {
    int[] counts = new int[Severity.values().length];
    entries.forEach(entry -> counts[entry.severity().ordinal()]++);
    return new ProblemCounts(
        counts[Severity.ERROR.ordinal()],
        counts[Severity.WARNING.ordinal()],
        counts[Severity.INFO.ordinal()]);
  }

  /** Of one kind. */
  public int of(Severity severity) {
    return switch (severity) {
      case ERROR -> errors;
      case WARNING -> warnings;
      case INFO -> remarks;
    };
  }

  /** As a status line shows it: {@code 2 errors, 1 remark}, or {@code No problems}. */
  public String words() {
    List<String> words = new ArrayList<>();
    for (Severity severity : Severity.values()) {
      if (of(severity) > 0) {
        words.add(words(severity));
      }
    }
    return words.isEmpty() ? "No problems" : String.join(", ", words);
  }

  /** Of one kind, as a button shows it. */
  String words(Severity severity) {
    int count = of(severity);
    String word =
        switch (severity) {
          case ERROR -> "error";
          case WARNING -> "warning";
          case INFO -> "remark";
        };
    return "%,d %s%s".formatted(count, word, count == 1 ? "" : "s");
  }
}
