package org.selectiverenderer.enricher.problems;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.document.ElementFinding;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A line of the list of problems.
 *
 * @param place in the document; or in another file
 * @param fix where one is obvious
 */
record ProblemEntry(
    Severity severity, String message, Place place, Optional<ElementFinding.Fix> fix) {
  private static final Pattern RULE = Pattern.compile(" \\[(SR\\d+)]$");

  /** Where a problem is. */
  sealed interface Place {
    /**
     * In an element, which edits may move.
     *
     * @param within characters behind the element's start
     * @param changed when the element had changed last; after later changes only its start is sure
     */
    record InElement(DocumentElement element, int within, long changed) implements Place {}

    /** In a text that is not well formed. */
    record InText(int offset) implements Place {}

    /** In another file, or nowhere. */
    record Elsewhere(Location location) implements Place {}
  }

  static ProblemEntry of(ElementFinding finding) {
    return new ProblemEntry(
        finding.severity(),
        finding.message(),
        new Place.InElement(finding.element(), 0, finding.element().changed()),
        finding.fix());
  }

  /** Whether its place is still there. */
  boolean current() {
    return !(place instanceof Place.InElement in) || in.element().attached();
  }

  /** The element to select. */
  Optional<DocumentElement> element() {
    return place instanceof Place.InElement in ? Optional.of(in.element()) : Optional.empty();
  }

  /** The offset to go to in the text as it is now. */
  Optional<Integer> offset() {
    if (place instanceof Place.InElement in) {
      DocumentElement element = in.element();
      return Optional.of(element.start() + (element.changed() == in.changed() ? in.within() : 0));
    }
    return place instanceof Place.InText in ? Optional.of(in.offset()) : Optional.empty();
  }

  /** Where it is in another file, such as one that the scene inlines. */
  Optional<Location> otherFile() {
    return place instanceof Place.Elsewhere other && !other.location().file().isEmpty()
        ? Optional.of(other.location())
        : Optional.empty();
  }

  /** Where it is now, for messages. */
  Location location(SceneDocument document) {
    return place instanceof Place.Elsewhere other
        ? other.location()
        : document.location(offset().orElseThrow());
  }

  /** The same thing said twice, by different checks. */
  boolean repeats(ProblemEntry other) {
    return place.equals(other.place) && message.equals(other.message)
        || element().isPresent()
            && element().equals(other.element())
            && (stem().startsWith(other.stem()) || other.stem().startsWith(stem()));
  }

  /** The same, taken at least as seriously. */
  ProblemEntry atLeast(Severity other) {
    return other.compareTo(severity) < 0 ? new ProblemEntry(other, message, place, fix) : this;
  }

  /** The validator's rule, {@code SR103}; empty where no rule is named. */
  Optional<String> rule() {
    Matcher named = RULE.matcher(message);
    return named.find() ? Optional.of(named.group(1)) : Optional.empty();
  }

  /** The message without the rule that a validator names behind it. */
  String stem() {
    return RULE.matcher(message).replaceFirst("");
  }
}
