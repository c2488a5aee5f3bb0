package org.selectiverenderer.base.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Collects problems; safe for use by several threads. A listener hears each as it is found. After
 * {@link #LIMIT} problems of one file the rest are counted and summed up in one line, so that a
 * broken file of a million numbers costs bounded memory.
 */
public final class Problems {
  /** Problems kept per file. */
  public static final int LIMIT = 100;

  private final Consumer<Problem> listener;
  private final List<Problem> list = new ArrayList<>();
  private final java.util.Map<String, Integer> perFile = new java.util.HashMap<>();
  private boolean errors;

  /** Problems that are kept. */
  public Problems() {
    this(problem -> {});
  }

  /** Problems that are kept, and told as they are found. */
  public Problems(Consumer<Problem> listener) {
    this.listener = listener;
  }

  /** Adds something that is wrong. */
  public void error(Location location, String message) {
    add(new Problem(Problem.Severity.ERROR, location, message));
  }

  /** Adds something that is probably wrong. */
  public void warning(Location location, String message) {
    add(new Problem(Problem.Severity.WARNING, location, message));
  }

  /** Adds something worth knowing. */
  public void info(Location location, String message) {
    add(new Problem(Problem.Severity.INFO, location, message));
  }

  /** Adds a problem. */
  public synchronized void add(Problem problem) {
    int count = perFile.merge(problem.location().file(), 1, Integer::sum);
    if (problem.severity() != Problem.Severity.INFO) {
      errors = true;
    }
    if (count == LIMIT + 1) {
      problem =
          new Problem(
              Problem.Severity.ERROR,
              Location.of(problem.location().file()),
              "more than " + LIMIT + " problems; the rest are not listed");
    } else if (count > LIMIT) {
      return;
    }
    list.add(problem);
    listener.accept(problem);
  }

  /** All problems so far, in the order found. */
  public synchronized List<Problem> list() {
    return List.copyOf(list);
  }

  /** Whether any error or warning was found: the input has problems. */
  public synchronized boolean any() {
    return errors;
  }
}
