package org.selectiverenderer.enricher.form;

import java.util.Optional;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyDegree;

/**
 * Parses and formats a degree of consistency as an author types it: low, high, a number from 0 to
 * 1, or none.
 */
final class DegreeFormat {
  /** The text for a degree that is not set. */
  static String none() {
    return Texts.of("form.none");
  }

  private DegreeFormat() {}

  static ParseResult<Optional<ConsistencyDegree>> parse(String text) {
    String word = text.strip().replace(',', '.');
    if (word.isEmpty() || word.equalsIgnoreCase(none())) {
      return new ParseResult.Valid<>(Optional.empty());
    }
    Optional<ConsistencyDegree> degree = ConsistencyDegree.of(word);
    return degree.isPresent()
        ? new ParseResult.Valid<>(degree)
        : new ParseResult.Wrong<>(Texts.of("form.degree.wrong"));
  }

  static String format(Optional<ConsistencyDegree> degree) {
    return degree.map(ConsistencyDegree::spelling).orElse(none());
  }
}
