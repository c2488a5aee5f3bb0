package org.selectiverenderer.study.web;

import java.util.HashMap;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/** Reports what is wrong in files that strangers sent: the first faults of each file. */
final class RecordFaults {
  private static final int MOST = 20;

  private final ProblemCollector problems;
  private final Map<String, Integer> told = new HashMap<>();

  RecordFaults(ProblemCollector problems) {
    this.problems = problems;
  }

  void tell(SourceLocation place, String sentence) {
    int number = told.merge(place.file(), 1, Integer::sum);
    if (number <= MOST) {
      problems.error(place, sentence);
    } else if (number == MOST + 1) {
      problems.error(place, "there are more faults in this file, which are not told");
    }
  }

  /** Returns a text of a stranger in quotes, on one line and not longer than a sentence. */
  static String quoted(String text) {
    String line = text.replaceAll("\\p{Cntrl}+", " ");
    return "'" + (line.length() > 60 ? line.substring(0, 60) + "..." : line) + "'";
  }
}
