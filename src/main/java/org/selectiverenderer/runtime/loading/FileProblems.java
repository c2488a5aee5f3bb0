package org.selectiverenderer.runtime.loading;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;

/**
 * The problems of one file in document order, regardless of the thread that finds them. It keeps
 * only as many as will be listed, the first ones in that order. Thread-safe.
 */
final class FileProblems {
  /** Order by location; problems of the file as a whole come last. */
  private static final Comparator<Problem> DOCUMENT_ORDER =
      Comparator.comparingInt(FileProblems::line)
          .thenComparingInt(problem -> problem.location().column())
          .thenComparing(Problem::severity)
          .thenComparing(Problem::message);

  private final TreeSet<Problem> first = new TreeSet<>(DOCUMENT_ORDER);

  private static int line(Problem problem) {
    int line = problem.location().line();
    return line == 0 ? Integer.MAX_VALUE : line;
  }

  synchronized void addAll(Collection<Problem> problems) {
    for (Problem problem : problems) {
      first.add(problem);
      if (first.size() > Problems.LIMIT + 1) {
        first.pollLast();
      }
    }
  }

  synchronized List<Problem> list() {
    return List.copyOf(first);
  }
}
