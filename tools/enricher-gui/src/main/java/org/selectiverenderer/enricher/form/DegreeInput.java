package org.selectiverenderer.enricher.form;

import java.util.Optional;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.Degree;

/**
 * Parses and formats a degree of consistency as an author types it: low, high, a number from 0 to
 * 1, or none.
 */
final class DegreeInput {
  /** The text for a degree that is not set. */
  static String none() {
    return Texts.of("form.none");
  }

  private DegreeInput() {}

  static Input<Optional<Degree>> parse(String text) {
    String word = text.strip().replace(',', '.');
    if (word.isEmpty() || word.equalsIgnoreCase(none())) {
      return new Input.Valid<>(Optional.empty());
    }
    Optional<Degree> degree = Degree.of(word);
    return degree.isPresent()
        ? new Input.Valid<>(degree)
        : new Input.Wrong<>(Texts.of("form.degree.wrong"));
  }

  static String format(Optional<Degree> degree) {
    return degree.map(Degree::spelling).orElse(none());
  }
}
