package org.selectiverenderer.statistics.data;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.csv.CsvErrorHandler;

/** Collects the exclusions of a file and reports each as a problem. */
final class ExclusionLog implements CsvErrorHandler {
  private final ProblemCollector problems;
  private final String row;
  private final List<Exclusion> list = new ArrayList<>();

  /**
   * Creates an empty log.
   *
   * @param row what a row of the file is, for messages, such as {@code the answer}
   */
  ExclusionLog(ProblemCollector problems, String row) {
    this.problems = problems;
    this.row = row;
  }

  @Override
  public void fault(SourceLocation location, String message) {
    error(location, "", message + "; nothing is analysed");
  }

  @Override
  public void misfit(SourceLocation location, String message) {
    error(location, "", message + "; " + row + " is left out");
  }

  /** Records invalid data. */
  void error(SourceLocation location, String participant, String reason) {
    problems.error(location, named(participant, reason));
    list.add(new Exclusion(location, participant, reason));
  }

  /** Records missing data. */
  void warning(SourceLocation location, String participant, String reason) {
    problems.warning(location, named(participant, reason));
    list.add(new Exclusion(location, participant, reason));
  }

  private static String named(String participant, String reason) {
    return participant.isEmpty() ? reason : "participant " + participant + ": " + reason;
  }

  /** Returns the exclusions in the order of the file. */
  List<Exclusion> list() {
    List<Exclusion> sorted = new ArrayList<>(list);
    sorted.sort(
        Comparator.comparing((Exclusion exclusion) -> exclusion.location().file())
            .thenComparing(exclusion -> exclusion.location().line()));
    return sorted;
  }
}
