package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.source.ElementLocation;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.BaseUrl;

/** The state that the classes of this package share while a file is read. */
final class ReadContext {
  private static final int LONGEST_NAME = 100;

  final NodeCatalogue catalogue;
  final ReadLimits limits;
  final FieldParser parser = new FieldParser();
  final ProtoInstanceRecorder interfaces = new ProtoInstanceRecorder();
  private final List<ParsedNode> loose = new ArrayList<>();
  private final String source;
  private final ProblemCollector problems;
  final PrototypeLibraryProvider libraries;
  private final BaseUrl ofFile;
  private final boolean parts;
  private final Set<Problem> replayed = new HashSet<>();
  private int reported;
  private long turns;
  private int spent;
  private int replays;
  private int depth;

  private @Nullable BaseUrl base;
  private AngleUnit angles = AngleUnit.RADIANS;
  private final List<Problem> externFaults = new ArrayList<>();

  /**
   * Creates the state of reading one file.
   *
   * @param libraries provides the prototypes of other files
   * @param ofFile the base of the relative urls of the file
   * @param parts whether the nodes read will become children of other nodes
   */
  ReadContext(
      String source,
      NodeCatalogue catalogue,
      ReadLimits limits,
      ProblemCollector problems,
      PrototypeLibraryProvider libraries,
      BaseUrl ofFile,
      boolean parts) {
    this.source = source;
    this.parts = parts;
    this.libraries = libraries;
    this.ofFile = ofFile;
    this.catalogue = catalogue;
    this.limits = limits;
    this.problems = problems;
  }

  /** Counts a field value of an instance that refers to an ancestor of the instance. */
  void turnBack() {
    turns++;
  }

  /** Returns how many such references there are. */
  long turns() {
    return turns;
  }

  /** Returns whether any node may be at the top level, since it will be a child of another. */
  boolean parts() {
    return parts;
  }

  /** Adds a Script without a parent, which runs although it is not in the scene graph. */
  void loose(ParsedNode script) {
    loose.add(script);
  }

  List<ParsedNode> loose() {
    return loose;
  }

  String source() {
    return source;
  }

  /** Returns the base of relative urls in the current prototype body; null in the file itself. */
  @Nullable BaseUrl base() {
    return base;
  }

  void base(@Nullable BaseUrl ofBody) {
    base = ofBody;
  }

  /** Returns the current unit of angles, that of the file or of a prototype's file. */
  AngleUnit angles() {
    return angles;
  }

  void angles(AngleUnit stated) {
    angles = stated;
  }

  /** Reports an error of an EXTERNPROTO declaration. */
  void externFault(Problem.Severity severity, SourceLocation location, String message) {
    Problem problem = new Problem(severity, location, message);
    externFaults.add(problem);
    report(problem);
  }

  List<Problem> externFaults() {
    return externFaults;
  }

  /** Returns the base of relative urls: that of the prototype, or else of the file that uses it. */
  BaseUrl urlBase() {
    return base == null ? ofFile : base.or(ofFile);
  }

  void error(SourceLocation location, String message) {
    report(new Problem(Problem.Severity.ERROR, location, message));
  }

  void warning(SourceLocation location, String message) {
    report(new Problem(Problem.Severity.WARNING, location, message));
  }

  void info(SourceLocation location, String message) {
    report(new Problem(Problem.Severity.INFO, location, message));
  }

  /** Reports the errors in an attribute's value, each at its own location. */
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

  // An error in a prototype's body is reported once, however many instances there are.
  void report(Problem problem) {
    if (replays > 0 && (replayed.size() >= ProblemCollector.LIMIT * 10 || !replayed.add(problem))) {
      return;
    }
    reported++;
    problems.add(problem);
  }

  // Beyond the problems that are listed, locations and suggestions are not computed, which could
  // take quadratic time for a hostile file.
  private boolean crowded() {
    return reported > ProblemCollector.LIMIT;
  }

  /** Returns the location of an attribute's name. */
  SourceLocation at(ElementLocation place, int attribute) {
    return crowded() ? place.location() : place.attribute(attribute);
  }

  /** Returns a suggestion of a similar name, for the middle of a message; else "". */
  String question(String name, Iterable<String> candidates) {
    if (crowded() || name.length() > LONGEST_NAME) {
      return "";
    }
    return SpellingSuggester.nearest(name, candidates)
        .map(found -> " (did you mean " + found + "?)")
        .orElse("");
  }

  void startReplay() {
    replays++;
  }

  void endReplay() {
    replays--;
  }

  /** Enters an element; false, after a message, if the nesting is too deep. */
  boolean enter(SourceLocation location) {
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

  /** Returns how many nodes may still be read. */
  int left() {
    return Math.max(0, limits.maxNodes() - spent);
  }

  /**
   * Counts a node, or something of similar cost; returns false if the limit is reached, which is
   * reported once.
   */
  boolean spend(SourceLocation location) {
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
