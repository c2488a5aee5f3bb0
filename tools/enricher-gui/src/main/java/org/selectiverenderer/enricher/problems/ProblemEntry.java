package org.selectiverenderer.enricher.problems;

import java.util.Optional;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * An entry of the list of problems.
 *
 * @param place the place in the document or in another file
 * @param fix the fix, where one is known
 */
record ProblemEntry(
    Severity severity, String message, Place place, Optional<ElementFinding.Fix> fix) {
  private static final String START = " [";
  private static final String RULE = "SR";

  /** The place of a problem. */
  sealed interface Place {
    /**
     * A place in an element, which edits may move.
     *
     * @param within offset from the element's start
     * @param changed the element's last change when the problem was found; after later changes only
     *     the element's start is valid
     */
    record InElement(DocumentElement element, int within, long changed) implements Place {}

    /** A place in a text that is not well formed. */
    record InText(int offset) implements Place {}

    /** A place in another file, or none. */
    record Elsewhere(SourceLocation location) implements Place {}
  }

  static ProblemEntry of(ElementFinding finding) {
    return new ProblemEntry(
        finding.severity(),
        finding.message(),
        new Place.InElement(finding.element(), 0, finding.element().changed()),
        finding.fix());
  }

  /** Whether its element is still in the document. */
  boolean current() {
    return !(place instanceof Place.InElement in) || in.element().attached();
  }

  /** The element to select. */
  Optional<DocumentElement> element() {
    return place instanceof Place.InElement in ? Optional.of(in.element()) : Optional.empty();
  }

  /** The offset in the present text. */
  Optional<Integer> offset() {
    if (place instanceof Place.InElement in) {
      DocumentElement element = in.element();
      return Optional.of(element.start() + (element.changed() == in.changed() ? in.within() : 0));
    }
    return place instanceof Place.InText in ? Optional.of(in.offset()) : Optional.empty();
  }

  /** The location in another file, such as an inlined one; empty otherwise. */
  Optional<SourceLocation> otherFile() {
    return place instanceof Place.Elsewhere other && !other.location().file().isEmpty()
        ? Optional.of(other.location())
        : Optional.empty();
  }

  /** The present location, for messages. */
  SourceLocation location(SceneDocument document) {
    return place instanceof Place.Elsewhere other
        ? other.location()
        : document.location(offset().orElseThrow());
  }

  /** Whether another entry reports the same problem, found by a different check. */
  boolean repeats(ProblemEntry other) {
    return place.equals(other.place) && message.equals(other.message)
        || element().isPresent()
            && element().equals(other.element())
            && (stem().startsWith(other.stem()) || other.stem().startsWith(stem()));
  }

  /** Returns the entry with at least the other severity. */
  ProblemEntry atLeast(Severity other) {
    return other.compareTo(severity) < 0 ? new ProblemEntry(other, message, place, fix) : this;
  }

  /** Returns the entry with a fix. */
  ProblemEntry with(Optional<ElementFinding.Fix> found) {
    return new ProblemEntry(severity, message, place, found);
  }

  /** The validator's rule, {@code SR103}; empty where no rule is named. */
  Optional<String> rule() {
    int at = ruleAt();
    return at < 0
        ? Optional.empty()
        : Optional.of(message.substring(at + START.length(), message.length() - 1));
  }

  /** The message without the rule id at its end. */
  String stem() {
    int at = ruleAt();
    return at < 0 ? message : message.substring(0, at);
  }

  /**
   * Returns where the rule id begins, -1 for none. Without a pattern, as every entry of a long list
   * is asked after each edit.
   */
  private int ruleAt() {
    int at = message.endsWith("]") ? message.lastIndexOf(START) : -1;
    if (at < 0 || !message.startsWith(RULE, at + START.length())) {
      return -1;
    }
    int digits = at + START.length() + RULE.length();
    boolean number = digits < message.length() - 1;
    for (int i = digits; i < message.length() - 1; i++) {
      number &= message.charAt(i) >= '0' && message.charAt(i) <= '9';
    }
    return number ? at : -1;
  }
}
