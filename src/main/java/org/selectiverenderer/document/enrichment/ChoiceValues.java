package org.selectiverenderer.document.enrichment;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.Choice;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.schema.Degree;

/**
 * What is said of one choice of a Switch: a row of its form.
 *
 * @param schemas it belongs to, in order
 */
public record ChoiceValues(
    Optional<ConsistencyType> type, Optional<Degree> degree, List<String> schemas) {
  /** Nothing is said. */
  public static final ChoiceValues NONE =
      new ChoiceValues(Optional.empty(), Optional.empty(), List.of());

  public ChoiceValues {
    schemas = schemas.stream().map(String::strip).filter(s -> !s.isEmpty()).distinct().toList();
  }

  static ChoiceValues of(Choice choice) {
    return new ChoiceValues(choice.type(), choice.degree(), choice.schemas());
  }

  public ChoiceValues with(ConsistencyType other) {
    return new ChoiceValues(Optional.of(other), degree, schemas);
  }

  public ChoiceValues with(Degree other) {
    return new ChoiceValues(type, Optional.of(other), schemas);
  }

  public ChoiceValues with(List<String> other) {
    return new ChoiceValues(type, degree, other);
  }

  public boolean isEmpty() {
    return equals(NONE);
  }
}
