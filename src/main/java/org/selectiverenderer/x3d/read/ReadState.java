package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.base.problem.Spelling;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.source.ElementLocation;
import org.selectiverenderer.x3d.source.ReadLimits;

/** What the parts of one reader share while a file is read. */
final class ReadState {
  private static final int LONGEST_NAME = 100;

  final NodeCatalogue catalogue;
  final ReadLimits limits;
  final FieldParser parser = new FieldParser();
  final InterfaceReader interfaces = new InterfaceReader();
  private final List<ParsedNode> loose = new ArrayList<>();
  private final String source;
  private final Problems problems;
  final Libraries libraries;
  private final ContentBase ofFile;
  private final boolean parts;
  private final Set<Problem> replayed = new HashSet<>();
  private int reported;
  private long turns;
  private int spent;
  private int replays;
  private int depth;

  private @Nullable ContentBase base;
  private AngleUnit angles = AngleUnit.RADIANS;
  private final List<Problem> externFaults = new ArrayList<>();

  /**
   * @param libraries where prototypes of other files come from
   * @param ofFile where the relative urls of the file start
   * @param parts whether what is read is to become part of other nodes
   */
  ReadState(
      String source,
      NodeCatalogue catalogue,
      ReadLimits limits,
      Problems problems,
      Libraries libraries,
      ContentBase ofFile,
      boolean parts) {
    this.source = source;
    this.parts = parts;
    this.libraries = libraries;
    this.ofFile = ofFile;
    this.catalogue = catalogue;
    this.limits = limits;
    this.problems = problems;
  }

  /** A value of an instance names a node that the instance stands in. */
  void turnBack() {
    turns++;
  }

  /** How often that was. */
  long turns() {
    return turns;
  }

  /** Whether any node may stand at the top: it is to become part of another. */
  boolean parts() {
    return parts;
  }

  /** A Script that stands in no other node: it runs although it takes up no place. */
  void loose(ParsedNode script) {
    loose.add(script);
  }

  List<ParsedNode> loose() {
    return loose;
  }

  String source() {
    return source;
  }

  /** Where relative urls of the prototype's body that is read start; null in the file itself. */
  @Nullable ContentBase base() {
    return base;
  }

  void base(@Nullable ContentBase ofBody) {
    base = ofBody;
  }

  /** The unit of the angles that are read now: of the file, or of a prototype's. */
  AngleUnit angles() {
    return angles;
  }

  void angles(AngleUnit stated) {
    angles = stated;
  }

  /** Reports what is wrong with a prototype of another file, or with what is expected of it. */
  void externFault(Problem.Severity severity, Location location, String message) {
    Problem problem = new Problem(severity, location, message);
    externFaults.add(problem);
    report(problem);
  }

  List<Problem> externFaults() {
    return externFaults;
  }

  /** Where relative urls start now: beside the prototype, or else beside the file that uses it. */
  ContentBase urlBase() {
    return base == null ? ofFile : base.or(ofFile);
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
  void flaws(
      ElementLocation place,
      int attribute,
      String name,
      int leading,
      List<FieldParser.Flaw> flaws) {
    for (FieldParser.Flaw flaw : flaws) {
      report(
          new Problem(
              flaw.severity(),
              crowded() ? place.location() : place.inAttribute(attribute, flaw.offset() - leading),
              name + ": " + flaw.message()));
    }
  }

  // A fault in a prototype's body is told once, however many instances there are.
  void report(Problem problem) {
    if (replays > 0 && (replayed.size() >= Problems.LIMIT * 10 || !replayed.add(problem))) {
      return;
    }
    reported++;
    problems.add(problem);
  }

  // Beyond the problems that are listed, looking for places and names would be work for nothing; a
  // hostile file could make it quadratic.
  private boolean crowded() {
    return reported > Problems.LIMIT;
  }

  /** Where an attribute's name stands. */
  Location at(ElementLocation place, int attribute) {
    return crowded() ? place.location() : place.attribute(attribute);
  }

  /** Asks whether another name was meant, for the middle of a message; empty if none is near. */
  String question(String name, Iterable<String> candidates) {
    if (crowded() || name.length() > LONGEST_NAME) {
      return "";
    }
    return Spelling.nearest(name, candidates)
        .map(found -> " (did you mean " + found + "?)")
        .orElse("");
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

  /** How many nodes there may still be. */
  int left() {
    return Math.max(0, limits.maxNodes() - spent);
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
