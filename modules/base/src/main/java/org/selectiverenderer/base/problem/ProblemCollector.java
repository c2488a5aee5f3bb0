package org.selectiverenderer.base.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Collects problems, and passes each to a listener at once. Thread-safe. After {@link #LIMIT}
 * problems of one file a single line says that the rest are not listed, so that a broken file of a
 * million numbers takes bounded memory.
 */
public final class ProblemCollector {
  /** The maximum number of problems kept per file. */
  public static final int LIMIT = 100;

  private final Consumer<Problem> listener;
  private final List<Problem> list = new ArrayList<>();
  private final java.util.Map<String, Integer> perFile = new java.util.HashMap<>();
  private boolean findings;
  private boolean errors;

  /** Creates an empty collector without a listener. */
  public ProblemCollector() {
    this(problem -> {});
  }

  /** Creates an empty collector with a listener. */
  public ProblemCollector(Consumer<Problem> listener) {
    this.listener = listener;
  }

  /** Adds an error. */
  public void error(SourceLocation location, String message) {
    add(new Problem(Problem.Severity.ERROR, location, message));
  }

  /** Adds a warning. */
  public void warning(SourceLocation location, String message) {
    add(new Problem(Problem.Severity.WARNING, location, message));
  }

  /** Adds an information. */
  public void info(SourceLocation location, String message) {
    add(new Problem(Problem.Severity.INFO, location, message));
  }

  /** Adds a problem. */
  public synchronized void add(Problem problem) {
    int count = perFile.merge(problem.location().file(), 1, Integer::sum);
    findings |= problem.severity() != Problem.Severity.INFO;
    errors |= problem.severity() == Problem.Severity.ERROR;
    if (count == LIMIT + 1) {
      problem =
          new Problem(
              Problem.Severity.ERROR,
              SourceLocation.of(problem.location().file()),
              "more than " + LIMIT + " problems; the rest are not listed");
    } else if (count > LIMIT) {
      return;
    }
    list.add(problem);
    listener.accept(problem);
  }

  /** Returns all problems so far, in the order in which they were found. */
  public synchronized List<Problem> list() {
    return List.copyOf(list);
  }

  /** Returns whether any error or warning was found. */
  public synchronized boolean any() {
    return findings;
  }

  /** Returns whether any error was found. */
  public synchronized boolean anyError() {
    return errors;
  }
}
