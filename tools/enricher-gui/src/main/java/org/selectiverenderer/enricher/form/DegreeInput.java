package org.selectiverenderer.enricher.form;

import java.util.Optional;
import org.selectiverenderer.schema.Degree;

/** A degree of consistency as an author types it: low, high, a number from 0 to 1, or none. */
final class DegreeInput {
  /** What stands for nothing said. */
  static final String NONE = "none";

  private DegreeInput() {}

  static Input<Optional<Degree>> parse(String text) {
    String word = text.strip().replace(',', '.');
    if (word.isEmpty() || word.equalsIgnoreCase(NONE)) {
      return new Input.Valid<>(Optional.empty());
    }
    Optional<Degree> degree = Degree.of(word);
    return degree.isPresent()
        ? new Input.Valid<>(degree)
        : new Input.Wrong<>("Write low, high or a number from 0 to 1");
  }

  static String format(Optional<Degree> degree) {
    return degree.map(Degree::spelling).orElse(NONE);
  }
}
