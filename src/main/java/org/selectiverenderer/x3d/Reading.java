package org.selectiverenderer.x3d;

import java.util.HashSet;
import java.util.Set;

/** What the parts of one reader share while a file is read. */
final class Reading {
  final NodeCatalogue catalogue;
  final ReadLimits limits;
  final FieldParser parser = new FieldParser();
  private final String source;
  private final Problems problems;
  private final Set<Problem> replayed = new HashSet<>();
  private int spent;
  private int replays;
  private int depth;

  Reading(String source, NodeCatalogue catalogue, ReadLimits limits, Problems problems) {
    this.source = source;
    this.catalogue = catalogue;
    this.limits = limits;
    this.problems = problems;
  }

  String source() {
    return source;
  }

  void error(Location location, String message) {
    report(new Problem(Problem.Severity.ERROR, location, message));
  }

  void warning(Location location, String message) {
    report(new Problem(Problem.Severity.WARNING, location, message));
  }

  void info(Location location, String message) {
    report(new Problem(Problem.Severity.INFO, location, message));
  }

  /** Reports what is wrong with an attribute's value, each at its own place. */
  void flaws(Place place, int attribute, String name, int leading, Flaws flaws) {
    for (FieldParser.Flaw flaw : flaws.list()) {
      report(
          new Problem(
              flaw.severity(),
              place.inAttribute(attribute, flaw.offset() - leading),
              name + ": " + flaw.message()));
    }
  }

  // A fault in a prototype's body is told once, however many instances there are.
  private void report(Problem problem) {
    if (replays > 0 && (replayed.size() >= Problems.LIMIT * 10 || !replayed.add(problem))) {
      return;
    }
    problems.add(problem);
  }

  void startReplay() {
    replays++;
  }

  void endReplay() {
    replays--;
  }

  /** Goes one element deeper; false, with a message, when that is too deep. */
  boolean enter(Location location) {
    if (depth >= limits.maxDepth()) {
      error(
          location,
          "elements are nested more than "
              + limits.maxDepth()
              + " deep, which is the limit; this one is left out");
      return false;
    }
    depth++;
    return true;
  }

  void leave() {
    depth--;
  }

  /**
   * Counts a node, or something that costs as much; false, with one message, when the limit is
   * reached.
   */
  boolean spend(Location location) {
    if (spent < limits.maxNodes()) {
      spent++;
      return true;
    }
    if (spent == limits.maxNodes()) {
      spent++;
      error(
          location,
          "the file has more than "
              + limits.maxNodes()
              + " nodes and routes, which is the limit; the rest is left out");
    }
    return false;
  }
}
